// Which body each point of a reconstruction belongs to, by the vote of the frames that it was made of.
// Points in the frame of the recording's map, frames with poses and instance numbers -> a number for each point. A frame
// votes for a point that it saw: the point falls into the image and lies where the depth image has a surface. As the
// poses are those that the reconstruction was made with, an error of the pose moves both alike.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/sensors.hpp"
#include "dataset/recording.hpp"

namespace amiss::dataset {

class InstanceVotes {
 public:
  explicit InstanceVotes(std::vector<Eigen::Vector3f> points_map);

  /// `numbers` has the frame's size.
  void add(const PosedFrame& frame, std::span<const std::uint16_t> numbers);
  /// The number with the most votes, the smaller one of equals; 0 where no frame saw the point.
  [[nodiscard]] std::vector<std::uint16_t> numbers() const;

 private:
  static constexpr std::size_t kKinds = 4;  // that can stand against each other at one point
  struct Votes {
    std::array<std::uint16_t, kKinds> number{};
    std::array<std::uint16_t, kKinds> count{};
  };
  static void count(Votes& votes, std::uint16_t number);

  std::vector<Eigen::Vector3f> points_map_;
  std::vector<Votes> votes_;
};

}  // namespace amiss::dataset
