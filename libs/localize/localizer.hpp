// Where the robot is on a known map: Monte Carlo localization (Thrun, Burgard, Fox, Probabilistic Robotics, 8.3) by
// MRPT's particle filter with the likelihood field of the map, followed by a few Gauss-Newton steps of the scan on the
// map's distance field.
// Where scans and map disagree for some time, the scan is searched on the whole map: a robot that was carried away
// finds itself again, as soon as one place fits much better than where it believed to be and better than all others.
// Odometry (50 Hz) moves the pose smoothly; scans correct T_map_odom. Poses in metres and radians, covariance of
// x [m], y [m], yaw [rad] from the particles. `converged` is false while the particles are wide, the scan does not fit
// the map, or the last scan moved the pose by more than odometry errs.
// Errors: ArgumentError for a map without an occupied cell or parameters that contradict each other.
//
// MRPT draws from one generator for the whole process. update() with a scan seeds it from this localizer's own stream
// first, so that runs are repeatable; two localizers must not update at the same time in two threads.
#pragma once

#include <memory>

#include "core/floor_grid.hpp"
#include "core/params.hpp"
#include "core/random.hpp"
#include "core/sensors.hpp"

namespace amiss::localize {

struct LocalizerParams {
  int particles = 300;
  int beams = 72;                      // of a scan that the particle filter weighs
  double hit_sigma_m = 0.08;           // of the likelihood field, wider than the laser's so that particles survive
  double hit_weight = 0.85;            // the rest is uniform: things that are not in the map
  double odometry_xy_per_m = 0.06;     // standard deviation of the motion model for a metre driven
  double odometry_yaw_per_rad = 0.06;  // and for a radian turned
  double odometry_yaw_per_m_rad = 0.03;
  double max_spread_m = 0.25;  // of particles that count as converged
  double min_fit = 0.5;        // part of the beams within fit_distance_m of a wall that counts as converged
  double fit_distance_m = 0.15;
  double sure_fit = 0.8;           // below it the pose is believed only when no other place of the map fits better
  double max_correction_m = 0.04;  // of one scan that counts as converged
  double max_correction_rad = radians(1.5);
  bool relocalize = true;  // search the whole map where scans and map disagree
  bool refine = true;      // Gauss-Newton on the distance field after the filter
};
void describe(ParamTable& table, LocalizerParams& p);

/// Standard deviations of where the robot starts.
struct StartSpread {
  double xy_m = 0.1;
  double yaw_rad = radians(3.0);
};

/// Why a pose should be believed.
struct LocalizationEvidence {
  double spread_m = 0.0;        // standard deviation of the particles' positions
  double fit = 0.0;             // part of the beams that end near a wall of the map, from the estimate
  double effective_part = 0.0;  // effective sample size / particles, before resampling
  double correction_m = 0.0, correction_rad = 0.0;  // by the last scan, of what odometry had predicted
  int relocalizations = 0;                          // poses found on the whole map, so far
  int scans = 0;                                    // used so far
};

class Localizer {
 public:
  Localizer(const FloorGrid& map, const Pose2<Map, Base>& start, const StartSpread& spread,
            const LocalizerParams& params, RandomStream random);
  ~Localizer();
  Localizer(Localizer&&) noexcept;
  Localizer& operator=(Localizer&&) noexcept;

  /// Stamps must not go back. `scan` may be null; else it was taken at the odometry's stamp.
  PoseEstimate update(const Odometry& odometry, const LaserScan* scan, const Transform<Base, Laser>& T_base_laser);

  /// Composes with the odometry of any stamp, also an earlier one: T_map_base = T_map_odom() * T_odom_base(then).
  [[nodiscard]] Pose2<Map, Odom> T_map_odom() const;
  [[nodiscard]] const PoseEstimate& estimate() const;
  [[nodiscard]] const LocalizationEvidence& evidence() const;
  /// The last scan fits the map where the robot believes to be; unlike `converged` also while scans correct the pose.
  [[nodiscard]] bool is_sure() const;

  /// Spread the particles anew, around a pose.
  void relocalize(const Pose2<Map, Base>& around, const StartSpread& spread);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace amiss::localize
