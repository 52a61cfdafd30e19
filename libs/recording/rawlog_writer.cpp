#include "recording/rawlog_writer.hpp"

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRawDAQ.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <future>
#include <stdexcept>

#include "core/worker.hpp"
#include "recording/internal/decisions.hpp"
#include "recording/internal/exact_depth.hpp"
#include "recording/robot_messages.hpp"

namespace amiss::recording {

namespace {

constexpr int kCompression = 1;

mrpt::Clock::time_point time_of(Stamp stamp) { return mrpt::Clock::fromDouble(seconds(stamp)); }

mrpt::poses::CPose3D pose_of(const Eigen::Isometry3d& T) {
  return mrpt::poses::CPose3D(mrpt::math::CMatrixDouble44(T.matrix()));
}

mrpt::obs::CObservationOdometry odometry_of(const Odometry& odometry) {
  mrpt::obs::CObservationOdometry o;
  o.sensorLabel = "ODOMETRY";
  o.timestamp = time_of(odometry.stamp);
  const auto& pose = odometry.T_odom_base;
  o.odometry = mrpt::poses::CPose2D(pose.x_m, pose.y_m, pose.yaw_rad);
  return o;
}

mrpt::obs::CObservation2DRangeScan scan_of(const LaserScan& scan, const Eigen::Isometry3d& T_base_laser) {
  mrpt::obs::CObservation2DRangeScan o;
  o.sensorLabel = "LASER";
  o.timestamp = time_of(scan.stamp);
  o.sensorPose = pose_of(T_base_laser);
  o.rightToLeft = true;
  o.maxRange = static_cast<float>(scan.max_range_m);
  o.aperture = static_cast<float>(scan.angle_step_rad * (static_cast<double>(scan.ranges_m.size()) - 1.0));
  // MRPT's scans are symmetric about their x axis: what is not is turned into the sensor's pose.
  const double middle = scan.angle_min_rad + 0.5 * static_cast<double>(o.aperture);
  o.sensorPose = o.sensorPose + mrpt::poses::CPose3D(0, 0, 0, middle, 0, 0);
  o.resizeScan(scan.ranges_m.size());
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    const bool valid = std::isfinite(scan.ranges_m[i]);
    o.setScanRange(i, valid ? scan.ranges_m[i] : o.maxRange);
    o.setScanRangeValidity(i, valid);
  }
  return o;
}

mrpt::img::TCamera camera_of(const CameraIntrinsics& c) {
  mrpt::img::TCamera camera;
  camera.ncols = static_cast<unsigned>(c.width);
  camera.nrows = static_cast<unsigned>(c.height);
  camera.setIntrinsicParamsFromValues(c.fx, c.fy, c.cx, c.cy);
  return camera;
}

/// MRPT's depth cameras look along x, z up.
Eigen::Isometry3d optical_from_body() {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  return T;
}

mrpt::obs::CObservation3DRangeScan frame_of(const robot::CapturedFrame& captured) {
  const RgbdFrame& frame = captured.frame;
  const CameraIntrinsics& c = frame.intrinsics;
  mrpt::obs::CObservation3DRangeScan o;
  o.sensorLabel = "CAMERA";
  o.timestamp = time_of(frame.stamp);
  o.sensorPose = pose_of(captured.T_base_camera.T * optical_from_body());
  o.cameraParams = o.cameraParamsIntensity = camera_of(c);
  o.range_is_depth = true;
  o.maxRange = internal::kMostDepthM;
  o.rangeUnits = internal::kDepthUnitM;
  o.hasRangeImage = true;
  o.rangeImage_setSize(c.height, c.width);
  o.hasIntensityImage = true;
  o.intensityImageChannel = mrpt::obs::CObservation3DRangeScan::CH_VISIBLE;
  o.intensityImage.resize(static_cast<std::size_t>(c.width), static_cast<std::size_t>(c.height), mrpt::img::CH_RGB);
  std::size_t i = 0;
  for (unsigned v = 0; v < o.cameraParams.nrows; ++v) {
    for (unsigned u = 0; u < o.cameraParams.ncols; ++u, ++i) {
      o.rangeImage(v, u) = internal::millimetres(frame.depth_m[i]);
      auto* bgr = o.intensityImage.ptr<std::uint8_t>(u, v);
      bgr[0] = frame.colour[i].b;
      bgr[1] = frame.colour[i].g;
      bgr[2] = frame.colour[i].r;
    }
  }
  return o;
}

mrpt::obs::CObservationRawDAQ data_of(const std::string& label, Stamp stamp, std::string_view bytes) {
  mrpt::obs::CObservationRawDAQ o;
  o.sensorLabel = label;
  o.timestamp = time_of(stamp);
  o.AIN_8bits.assign(bytes.begin(), bytes.end());
  return o;
}

mrpt::obs::CObservationRawDAQ rest_of(const RgbdFrame& frame) {
  mrpt::obs::CObservationRawDAQ o = data_of(RawlogWriter::kDepth, frame.stamp, {});
  for (const float depth : frame.depth_m) o.AIN_32bits.push_back(internal::rest(depth, internal::millimetres(depth)));
  return o;
}

}  // namespace

struct RawlogWriter::State {
  std::filesystem::path path;
  Eigen::Isometry3d T_base_laser;
  bool for_replay = false;
  Stamp now;
  mrpt::io::CFileGZOutputStream stream;
  std::future<void> writing;
  Worker worker;  // the last member, so that it ends before what it works on

  State(const std::filesystem::path& file, const Transform<Base, Laser>& laser, bool threaded)
      : path(file), T_base_laser(laser.T), worker(threaded) {
    if (!stream.open(file.string(), kCompression)) throw std::runtime_error(file.string() + ": cannot be written");
  }
  void write(const robot::Observation& observation) {
    auto archive = mrpt::serialization::archiveFrom(stream);
    archive << odometry_of(observation.odometry);
    if (observation.scan) archive << scan_of(*observation.scan, T_base_laser);
    if (observation.frame) archive << frame_of(*observation.frame);
    if (!for_replay) return;
    if (observation.frame) archive << rest_of(observation.frame->frame);
    archive << data_of(kObservation, observation.stamp, observation_message(observation));
  }
  void put(const std::string& label, const std::string& bytes) {
    join();
    writing = worker.submit([this, label, bytes, stamp = now] {
      mrpt::serialization::archiveFrom(stream) << data_of(label, stamp, bytes);
    });
  }
  void join() {
    if (writing.valid()) writing.get();
  }
};

RawlogWriter::RawlogWriter(const std::filesystem::path& file, const Transform<Base, Laser>& T_base_laser, bool threaded)
    : state_(std::make_unique<State>(file, T_base_laser, threaded)) {}

RawlogWriter::RawlogWriter(const std::filesystem::path& file, const RunSetup& setup, bool threaded)
    : RawlogWriter(file, setup.model->T_base_laser, threaded) {
  state_->for_replay = true;
  state_->put(kSetup, setup_message({setup.seed, setup.method, setup.model->T_base_laser}));
  for (const auto& [name, bytes] : setup.documents) state_->put(kDocuments + name, bytes);
}

RawlogWriter::~RawlogWriter() = default;

void RawlogWriter::record(const robot::Observation& observation) {
  state_->join();
  state_->now = observation.stamp;
  state_->writing = state_->worker.submit([state = state_.get(), observation] { state->write(observation); });
}

void RawlogWriter::attach(mission::Sinks& sinks) {
  internal::tell_decisions(
      sinks, [this](const char* topic, const char*, const std::string& message) { state_->put(topic, message); });
}

void RawlogWriter::close() {
  state_->join();
  state_->stream.close();
}

}  // namespace amiss::recording
