#include "recording/bag_source.hpp"

namespace amiss::recording {

BagSource::BagSource(const std::filesystem::path& file, const dataset::RobotBagOptions& options,
                     const Pose2<Map, Base>& T_map_base)
    : bag_(file, options), setup_{1, "bag", bag_.T_base_laser(), T_map_base} {}

std::optional<Entry> BagSource::next() {
  auto moment = bag_.next();
  complete_ = !moment;
  if (!moment) return std::nullopt;
  robot::Observation observation;
  observation.stamp = moment->odometry.stamp;
  observation.odometry = moment->odometry;
  observation.scan = std::move(moment->scan);
  if (moment->frame) {
    auto& [frame, T_base_camera, T_odom_base] = *moment->frame;
    observation.frame = robot::CapturedFrame{std::move(frame), T_base_camera, T_odom_base};
  }
  return observation;
}

}  // namespace amiss::recording
