// The nearest of some points for every cell of a box, found once: many look-ups of ICP at the cost of an index.
// in: points [m], box [m], reach [m]. out: index of a point that is nearest up to a fraction of a cell, none farther
// than about the reach.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace amiss::change::internal {

class NearestField {
 public:
  NearestField(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& low, const Eigen::Vector3f& high,
               float reach_m);

  [[nodiscard]] std::optional<std::uint32_t> nearest(const Eigen::Vector3f& p) const;

 private:
  using Cell = std::array<int, 3>;
  [[nodiscard]] Cell cell_of(const Eigen::Vector3f& p) const;
  [[nodiscard]] bool inside(const Cell& c) const;
  [[nodiscard]] std::size_t index(const Cell& c) const;
  [[nodiscard]] Eigen::Vector3f centre_of(const Cell& c) const;
  void spread(const std::vector<Eigen::Vector3f>& points, std::vector<Cell> front, int rings);

  Eigen::Vector3f low_;
  Cell size_{};
  std::vector<std::uint32_t> nearest_;
};

}  // namespace amiss::change::internal
