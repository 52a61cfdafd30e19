#include "dataset_recorder.hpp"

#include <algorithm>

#include "core/files.hpp"
#include "core/result.hpp"

namespace amiss::app {

namespace {

constexpr std::size_t kMoments = 100;  // 2 s: a frame arrives sooner

}  // namespace

DatasetRecorder::DatasetRecorder(const std::filesystem::path& folder, const sim::Simulator& simulator,
                                 const Pose2<World, Map>& T_world_map, double floor_clearance_m)
    : folder_(folder),
      simulator_(simulator),
      T_world_map_(T_world_map),
      floor_clearance_m_(floor_clearance_m),
      writer_(folder, {simulator.model().camera, dataset::kTumDepthScale}),
      instances_(folder / "truth") {}

void DatasetRecorder::also_as_rawlog() {
  rawlog_ =
      std::make_unique<recording::RawlogWriter>(folder_ / "recording.rawlog", simulator_.model().T_base_laser, false);
}

void DatasetRecorder::observed(const robot::Observation& seen) {
  if (rawlog_) rawlog_->record(seen);
  log_.add(seen.odometry);
  if (seen.scan) log_.add(*seen.scan, seen.odometry, simulator_.model().T_base_laser);
  const Transform<Base, Camera> T_base_camera = simulator_.model().T_base_camera(seen.head);
  moments_.push_back({seen.stamp, simulator_.truth().T_world_base.lift() * T_base_camera});
  if (moments_.size() > kMoments) moments_.pop_front();
}

void DatasetRecorder::believed(const mission::StepEvent& step) {
  poses_.push_back({step.pose.stamp, simulator_.truth().T_world_base, step.pose.T_map_base});
}

void DatasetRecorder::framed(const mission::FrameEvent& event) {
  const RgbdFrame& frame = *event.frame;
  const world::InstanceImage* shown = simulator_.instances_of(frame.stamp);
  const auto moment =
      std::find_if(moments_.begin(), moments_.end(), [&](const Moment& m) { return m.stamp == frame.stamp; });
  if (shown == nullptr || moment == moments_.end()) return;  // of before the recording
  dataset::PosedFrame posed{frame, event.T_map_camera};
  posed.T_map_camera.T.pretranslate(Eigen::Vector3d(0.0, 0.0, floor_clearance_m_));
  writer_.add(posed, T_world_map_.lift().inverse() * moment->T_world_camera);
  instances_.add(frame.stamp, shown->width, shown->height, shown->instances);
  ++frames_;
}

void DatasetRecorder::finish() {
  if (rawlog_) rawlog_->close();
  instances_.finish();
  save_atomically(folder_ / "laser.log", log_.bytes());
  writer_.save_associations();
  writer_.finish();
}

}  // namespace amiss::app
