#include "mission/perception.hpp"

#include <algorithm>
#include <cmath>

#include "motion/drive_map.hpp"

namespace amiss::mission {

namespace {

double part_returned(const LaserScan& scan) {
  const auto met = [](float range_m) { return std::isfinite(range_m); };
  const auto returned = std::count_if(scan.ranges_m.begin(), scan.ranges_m.end(), met);
  return static_cast<double>(returned) / std::max(1.0, static_cast<double>(scan.ranges_m.size()));
}

}  // namespace

void describe(ParamTable& table, PerceptionParams& p) {
  table.number("perception.floor_clearance", p.floor_clearance_m, "m", 0.0, 0.05,
               "z = 0 of the map above the floor, so that the floor's noise stays in the voxels under it");
  table.number("perception.obstacle_range", p.obstacle_range_m, "m", 0.5, 20.0,
               "of laser hits that count as obstacles");
}

Perception::Perception(robot::Robot& robot, std::unique_ptr<Tracker> tracker, const FloorGrid& floor,
                       const mapping::VoxelMapParams& voxels, const PerceptionParams& params, const Sinks& sinks)
    : robot_(robot),
      tracker_(std::move(tracker)),
      params_(params),
      sinks_(sinks),
      voxels_(voxels),
      layer_(floor, voxels.resolution_m),
      inserter_(params.threaded) {}

bool Perception::step(const robot::Command& command) {
  robot_.command(command);
  robot::Observation seen = robot_.observe();
  pose_ = tracker_->update(seen.odometry, seen.scan ? &*seen.scan : nullptr, robot_.model().T_base_laser);
  head_ = seen.head;
  bumper_ = seen.bumper;
  if (last_odometry_) {
    distance_m_ += (seen.odometry.T_odom_base.position() - last_odometry_->position()).norm();
  }
  last_odometry_ = seen.odometry.T_odom_base;
  if (seen.scan) {
    laser_hits_map_ =
        motion::laser_hits(*seen.scan, pose_.T_map_base, robot_.model().T_base_laser, params_.obstacle_range_m);
    returned_part_ = part_returned(*seen.scan);
  }
  if (seen.frame) keep(std::move(*seen.frame));
  sinks_.step({pose_, bumper_, head_});
  return !sinks_.stop() && !out_of_time();
}

Transform<Map, Camera> Perception::camera_pose(const robot::CapturedFrame& captured) const {
  Transform<Map, Base> T_map_base = (tracker_->T_map_odom() * captured.T_odom_base).lift();
  T_map_base.T.pretranslate(Eigen::Vector3d(0.0, 0.0, -params_.floor_clearance_m));
  return T_map_base * captured.T_base_camera;
}

void Perception::keep(robot::CapturedFrame captured) {
  join();
  const Transform<Map, Camera> T_map_camera = camera_pose(captured);
  last_frame_ = LocatedFrame{std::move(captured), T_map_camera};
  if (pose_.converged) {
    insertion_ = inserter_.submit([this] { voxels_.insert(last_frame_->captured.frame, last_frame_->T_map_camera); });
  }
  sinks_.frame({&last_frame_->captured.frame, T_map_camera});
}

void Perception::join() {
  if (insertion_.valid()) insertion_.get();
}

const mapping::VoxelMap& Perception::voxels() {
  join();
  return voxels_;
}

const mapping::ObstacleLayer& Perception::obstacles() {
  join();
  layer_.update(voxels_);
  return layer_;
}

void Perception::restart(std::unique_ptr<Tracker> tracker, const FloorGrid& floor) {
  join();
  tracker_ = std::move(tracker);
  layer_ = mapping::ObstacleLayer(floor, voxels_.resolution_m());
  voxels_ = mapping::VoxelMap(voxels_.params());
}

}  // namespace amiss::mission
