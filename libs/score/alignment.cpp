#include "score/alignment.hpp"

#include <algorithm>
#include <cmath>

namespace amiss::score {

Pose2<World, Map> align(const std::vector<PosePair>& pairs) {
  if (pairs.empty()) return {};
  Eigen::Vector2d mean_world = Eigen::Vector2d::Zero(), mean_map = Eigen::Vector2d::Zero();
  for (const PosePair& pair : pairs) {
    mean_world += pair.T_world_base.position();
    mean_map += pair.T_map_base.position();
  }
  mean_world /= static_cast<double>(pairs.size());
  mean_map /= static_cast<double>(pairs.size());
  double along = 0.0, across = 0.0, spread = 0.0;
  for (const PosePair& pair : pairs) {
    const Eigen::Vector2d m = pair.T_map_base.position() - mean_map;
    const Eigen::Vector2d w = pair.T_world_base.position() - mean_world;
    along += m.dot(w);
    across += m.x() * w.y() - m.y() * w.x();
    spread += m.squaredNorm();
  }
  constexpr double kLeastSpread = 0.01;  // m^2 a pose, below which the direction says nothing
  if (spread / static_cast<double>(pairs.size()) < kLeastSpread) {
    return pairs.front().T_world_base * pairs.front().T_map_base.inverse();
  }
  const double yaw = std::atan2(across, along);
  const Eigen::Vector2d offset = mean_world - Eigen::Rotation2Dd(yaw) * mean_map;
  return {offset.x(), offset.y(), yaw};
}

LocalizationError localization_error(const std::vector<PosePair>& pairs, const Pose2<World, Map>& T_world_map) {
  LocalizationError error;
  error.poses = pairs.size();
  if (pairs.empty()) return error;
  double squared_m = 0.0, squared_rad = 0.0;
  for (const PosePair& pair : pairs) {
    const Pose2<World, Base> estimate = T_world_map * pair.T_map_base;
    const double distance = (estimate.position() - pair.T_world_base.position()).norm();
    const double angle = wrap_angle(estimate.yaw_rad - pair.T_world_base.yaw_rad);
    squared_m += distance * distance;
    squared_rad += angle * angle;
    error.max_m = std::max(error.max_m, distance);
  }
  error.rmse_m = std::sqrt(squared_m / static_cast<double>(pairs.size()));
  error.rmse_rad = std::sqrt(squared_rad / static_cast<double>(pairs.size()));
  return error;
}

}  // namespace amiss::score
