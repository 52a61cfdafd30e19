// A user's ROS 1 bag of an HSR as something to replay: nobody compared or segmented in it, so the replay does.
//
// in: bag, its topics and frames (dataset/robot_bag.hpp), where on the map the robot begins
// out: an observation for each message of odometry and each scan; what a bag does not tell (head, bumper) is zero
// InputError as of RobotBag.
#pragma once

#include "dataset/robot_bag.hpp"
#include "recording/source.hpp"

namespace amiss::recording {

class BagSource final : public Source {
 public:
  BagSource(const std::filesystem::path& file, const dataset::RobotBagOptions& options,
            const Pose2<Map, Base>& T_map_base);

  [[nodiscard]] const Setup& setup() const override { return setup_; }
  [[nodiscard]] const std::map<std::string, std::string>& documents() const override { return documents_; }
  std::optional<Entry> next() override;
  [[nodiscard]] bool complete() const override { return complete_; }
  [[nodiscard]] std::size_t dropped() const override { return bag_.dropped(); }
  [[nodiscard]] bool tells_decisions() const override { return false; }

 private:
  dataset::RobotBag bag_;
  Setup setup_;
  std::map<std::string, std::string> documents_;  // none
  bool complete_ = false;
};

}  // namespace amiss::recording
