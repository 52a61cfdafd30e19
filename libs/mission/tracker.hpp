// Who says where the robot is: the particle filter on a known map, or SLAM while the map is being made.
// Odometry (each period) and scans (when there is one) -> PoseEstimate in the map frame.
#pragma once

#include "core/sensors.hpp"
#include "localize/laser_mapper.hpp"
#include "localize/localizer.hpp"

namespace amiss::mission {

class Tracker {
 public:
  virtual ~Tracker() = default;
  virtual PoseEstimate update(const Odometry& odometry, const LaserScan* scan,
                              const Transform<Base, Laser>& T_base_laser) = 0;
  [[nodiscard]] virtual Pose2<Map, Odom> T_map_odom() const = 0;
  /// Does the last scan fit the map so well that odometry may be judged by the pose?
  [[nodiscard]] virtual bool is_sure() const = 0;
};

class LocalizerTracker final : public Tracker {
 public:
  explicit LocalizerTracker(localize::Localizer localizer) : localizer_(std::move(localizer)) {}
  PoseEstimate update(const Odometry& odometry, const LaserScan* scan,
                      const Transform<Base, Laser>& T_base_laser) override {
    return localizer_.update(odometry, scan, T_base_laser);
  }
  [[nodiscard]] Pose2<Map, Odom> T_map_odom() const override { return localizer_.T_map_odom(); }
  [[nodiscard]] bool is_sure() const override { return localizer_.is_sure(); }

 private:
  localize::Localizer localizer_;
};

/// The mapper stays with its owner, who also wants its grid.
class MapperTracker final : public Tracker {
 public:
  explicit MapperTracker(localize::LaserMapper& mapper) : mapper_(mapper) {}
  PoseEstimate update(const Odometry& odometry, const LaserScan* scan,
                      const Transform<Base, Laser>& T_base_laser) override {
    if (scan != nullptr) return mapper_.update(odometry, *scan, T_base_laser);
    PoseEstimate estimate = mapper_.estimate();
    estimate.stamp = odometry.stamp;
    estimate.T_map_base = mapper_.T_map_odom() * odometry.T_odom_base;
    return estimate;
  }
  [[nodiscard]] Pose2<Map, Odom> T_map_odom() const override { return mapper_.T_map_odom(); }
  [[nodiscard]] bool is_sure() const override { return false; }  // its map is made with the odometry

 private:
  localize::LaserMapper& mapper_;
};

}  // namespace amiss::mission
