// Wheel odometry: the true motion, a little wrong. True poses of the base -> pose in the odom frame that drifts with
// the distance driven and the angle turned. Two errors: the scale of a run (worn wheels), and a random walk.
// The defaults are those of a well-kept base: about 1 % of the distance and 1.5 degrees a full turn.
#pragma once

#include "core/params.hpp"
#include "core/random.hpp"
#include "core/sensors.hpp"

namespace amiss::sim {

struct OdometryParams {
  double scale_sigma = 0.01;              // of the distance, one draw for a run
  double yaw_scale_sigma = 0.004;         // of the angle, one draw for a run: 1.4 degrees in a full turn
  double drift_m = 0.005;                 // standard deviation of the position after 1 m
  double yaw_drift_rad = 0.004;           // of the heading after 1 m
  double yaw_drift_per_turn_rad = 0.008;  // of the heading after a full turn
};
void describe(ParamTable& table, OdometryParams& params);

class OdometryModel {
 public:
  OdometryModel(const OdometryParams& params, RandomStream noise, const Pose2<amiss::World, Base>& start);

  /// Odometry starts at the origin of its frame.
  [[nodiscard]] Odometry update(Stamp stamp, const Pose2<amiss::World, Base>& T_world_base);
  /// The robot was lifted and put down here: wheels that do not turn feel nothing.
  void carried_to(const Pose2<amiss::World, Base>& T_world_base) { last_ = T_world_base; }

 private:
  OdometryParams params_;
  RandomStream noise_;
  double scale_ = 1.0, yaw_scale_ = 1.0;
  Pose2<amiss::World, Base> last_;
  Pose2<Odom, Base> T_odom_base_;
};

}  // namespace amiss::sim
