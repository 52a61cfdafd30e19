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
  describe(table, p.health);
}

Perception::Perception(robot::Robot& robot, std::unique_ptr<Tracker> tracker, const FloorGrid& floor,
                       const mapping::VoxelMapParams& voxels, const PerceptionParams& params, const Sinks& sinks)
    : robot_(robot),
      tracker_(std::move(tracker)),
      params_(params),
      sinks_(sinks),
      voxels_(voxels),
      layer_(floor, voxels.resolution_m),
      odometer_(robot.model().limits, params.health),
      laser_(params.health),
      camera_(params.health),
      inserter_(params.threaded) {}

bool Perception::step(const robot::Command& command) {
  robot_.command(command);
  robot::Observation seen = robot_.observe();
  odometer_.update(seen.odometry, seen.stamp, command);
  if (seen.scan && !laser_.accept(*seen.scan, odometer_.at(seen.scan->stamp))) seen.scan.reset();
  locate(seen);
  head_ = seen.head;
  bumper_ = seen.bumper;
  if (last_odometry_) distance_m_ += (odometer_.pose().position() - last_odometry_->position()).norm();
  last_odometry_ = odometer_.pose();
  if (seen.frame && camera_.accept(*seen.frame)) keep(std::move(*seen.frame));
  sinks_.step({pose_, bumper_, head_});
  return !sinks_.stop() && !out_of_time();
}

void Perception::locate(const robot::Observation& seen) {
  const Transform<Base, Laser>& T_base_laser = robot_.model().T_base_laser;
  const Odometry now{seen.stamp, odometer_.pose()};
  const bool on_time = seen.scan && seen.scan->stamp == seen.stamp;
  if (seen.scan && !on_time) {
    tracker_->update({seen.scan->stamp, odometer_.at(seen.scan->stamp)}, &*seen.scan, T_base_laser);
  }
  pose_ = tracker_->update(now, on_time ? &*seen.scan : nullptr, T_base_laser);
  if (pose_.converged) localized_ = seen.stamp;
  if (!seen.scan) return;
  odometer_.compare(pose_.T_map_base, tracker_->is_sure());
  const Pose2<Map, Base> then = on_time ? pose_.T_map_base : tracker_->T_map_odom() * odometer_.at(seen.scan->stamp);
  laser_hits_map_ = motion::laser_hits(*seen.scan, then, T_base_laser, params_.obstacle_range_m);
  returned_part_ = part_returned(*seen.scan);
}

std::optional<Trouble> Perception::trouble() const {
  if (const auto odometry = odometer_.trouble(now())) return odometry;
  if (const auto laser = laser_.trouble(now())) return laser;
  if (const auto camera = camera_.trouble(now())) return camera;
  if (now() - localized_ > duration_of(params_.health.lost_after_s)) {
    return Trouble{Sense::kPose, Complaint::kLost, localized_};
  }
  return std::nullopt;
}

Transform<Map, Camera> Perception::camera_pose(const robot::CapturedFrame& captured) const {
  const Pose2<Odom, Base> T_odom_base = odometer_.at(captured.frame.stamp, captured.T_odom_base);
  Transform<Map, Base> T_map_base = (tracker_->T_map_odom() * T_odom_base).lift();
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
