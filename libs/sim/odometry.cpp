#include "sim/odometry.hpp"

#include <cmath>

namespace amiss::sim {

void describe(ParamTable& table, OdometryParams& params) {
  table.number("odometry.scale_sigma", params.scale_sigma, "", 0.0, 0.2, "error of distances, one draw for a run");
  table.number("odometry.yaw_scale_sigma", params.yaw_scale_sigma, "", 0.0, 0.2, "error of angles, one draw for a run");
  table.number("odometry.drift", params.drift_m, "m", 0.0, 0.5, "deviation of the position after 1 m");
  table.number("odometry.yaw_drift", params.yaw_drift_rad, "deg", 0.0, 20.0, "deviation of the heading after 1 m");
  table.number("odometry.yaw_drift_per_turn", params.yaw_drift_per_turn_rad, "deg", 0.0, 45.0,
               "deviation of the heading after a full turn");
}

OdometryModel::OdometryModel(const OdometryParams& params, RandomStream noise, const Pose2<amiss::World, Base>& start)
    : params_(params), noise_(noise), last_(start) {
  scale_ = 1.0 + params_.scale_sigma * noise_.normal();
  yaw_scale_ = 1.0 + params_.yaw_scale_sigma * noise_.normal();
}

Odometry OdometryModel::update(Stamp stamp, const Pose2<amiss::World, Base>& T_world_base) {
  const Pose2<Base, Base> motion = last_.inverse() * T_world_base;
  last_ = T_world_base;
  const double distance_m = motion.position().norm();
  const double turns = std::abs(motion.yaw_rad) / (2.0 * std::numbers::pi);
  if (distance_m > 0.0 || turns > 0.0) {
    // A random walk: variances add up with the distance.
    const double sigma_m = params_.drift_m * std::sqrt(distance_m);
    const double sigma_yaw_rad =
        std::hypot(params_.yaw_drift_rad * std::sqrt(distance_m), params_.yaw_drift_per_turn_rad * std::sqrt(turns));
    Pose2<Base, Base> felt;
    felt.x_m = scale_ * motion.x_m + sigma_m * noise_.normal();
    felt.y_m = scale_ * motion.y_m + sigma_m * noise_.normal();
    felt.yaw_rad = yaw_scale_ * motion.yaw_rad + sigma_yaw_rad * noise_.normal();
    T_odom_base_ = T_odom_base_ * felt;
  }
  return {stamp, T_odom_base_};
}

}  // namespace amiss::sim
