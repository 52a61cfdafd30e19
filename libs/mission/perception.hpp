// What the robot knows of its surroundings, one control period after the other: observe -> localize -> insert.
// Commands -> pose in the map frame, voxel map, obstacles, floor seen. All decisions of a mission read from here; none
// of it knows the truth. What arrives late is used with the odometry of its instant; what a sensor says that is not to
// be believed is left out, and trouble() tells of it. Thesis, figure 4.2.
#pragma once

#include <future>
#include <memory>
#include <optional>

#include "core/worker.hpp"
#include "mapping/obstacle_layer.hpp"
#include "mapping/voxel_map.hpp"
#include "mission/camera_health.hpp"
#include "mission/laser_health.hpp"
#include "mission/odometer.hpp"
#include "mission/sinks.hpp"
#include "mission/tracker.hpp"
#include "robot/model.hpp"
#include "robot/robot.hpp"

namespace amiss::mission {

struct PerceptionParams {
  double floor_clearance_m = 0.012;  // z = 0 of the map above the floor: its noise stays in the voxels under it
  double obstacle_range_m = 4.0;     // of laser hits that count as obstacles
  double time_limit_s = 3600.0;      // simulated; the mission ends there
  HealthParams health;
  bool threaded = true;  // insert into the voxel map beside the caller; the result is the same
};
void describe(ParamTable& table, PerceptionParams& p);

/// A frame with the pose that the robot believes it was taken at.
struct LocatedFrame {
  robot::CapturedFrame captured;
  Transform<Map, Camera> T_map_camera;
};

class Perception {
 public:
  /// `floor` tells the area that the obstacle layer covers.
  Perception(robot::Robot& robot, std::unique_ptr<Tracker> tracker, const FloorGrid& floor,
             const mapping::VoxelMapParams& voxels, const PerceptionParams& params, const Sinks& sinks);

  /// One control period under this command. False: the mission has to end (stopped or out of time).
  bool step(const robot::Command& command);

  [[nodiscard]] const PoseEstimate& pose() const { return pose_; }
  [[nodiscard]] const robot::HeadState& head() const { return head_; }
  [[nodiscard]] bool bumper() const { return bumper_; }
  [[nodiscard]] const robot::Model& model() const { return robot_.model(); }
  /// With all frames so far: waits for the last one.
  [[nodiscard]] const mapping::VoxelMap& voxels();
  /// Obstacles and floor seen so far, brought up to date by this call.
  const mapping::ObstacleLayer& obstacles();
  [[nodiscard]] const std::optional<LocatedFrame>& last_frame() const { return last_frame_; }
  /// Where the beams of the last scan ended, in the map frame, by the pose at its instant.
  [[nodiscard]] const std::vector<Eigen::Vector2d>& laser_hits_map() const { return laser_hits_map_; }
  /// Part of the beams of the last scan that met something.
  [[nodiscard]] double returned_part() const { return returned_part_; }
  [[nodiscard]] Stamp now() const { return pose_.stamp; }
  /// What keeps the robot from going on, if anything does.
  [[nodiscard]] std::optional<Trouble> trouble() const;
  [[nodiscard]] bool out_of_time() const { return seconds(now()) >= params_.time_limit_s; }
  [[nodiscard]] double distance_m() const { return distance_m_; }
  [[nodiscard]] const Sinks& sinks() const { return sinks_; }

  /// From now on another tracker and another area, a fresh voxel map (second half of the mapping run).
  void restart(std::unique_ptr<Tracker> tracker, const FloorGrid& floor);

 private:
  [[nodiscard]] Transform<Map, Camera> camera_pose(const robot::CapturedFrame& captured) const;
  void locate(const robot::Observation& seen);
  void keep(robot::CapturedFrame captured);
  void join();

  robot::Robot& robot_;
  std::unique_ptr<Tracker> tracker_;
  PerceptionParams params_;
  const Sinks& sinks_;
  mapping::VoxelMap voxels_;
  mapping::ObstacleLayer layer_;
  PoseEstimate pose_;
  robot::HeadState head_;
  Odometer odometer_;
  LaserHealth laser_;
  CameraHealth camera_;
  Stamp localized_;  // last time that the pose was to be believed
  std::optional<Pose2<Odom, Base>> last_odometry_;
  double distance_m_ = 0.0;
  bool bumper_ = false;
  std::optional<LocatedFrame> last_frame_;
  std::vector<Eigen::Vector2d> laser_hits_map_;
  double returned_part_ = 1.0;
  std::future<void> insertion_;  // of last_frame_ into voxels_
  Worker inserter_;              // the last member, so that it ends before what it works on
};

}  // namespace amiss::mission
