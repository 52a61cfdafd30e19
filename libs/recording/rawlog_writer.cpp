#include "recording/rawlog_writer.hpp"

#include <libdeflate.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRawDAQ.h>
#include <mrpt/serialization/CArchive.h>

#include <fstream>
#include <stdexcept>

#include "recording/batches.hpp"
#include "recording/internal/decisions.hpp"
#include "recording/internal/exact_depth.hpp"
#include "recording/internal/mcap_bytes.hpp"
#include "recording/robot_messages.hpp"

namespace amiss::recording {

namespace {

constexpr int kCompression = 1, kJpegQuality = 80;
constexpr std::string_view kMemberHead("\x1f\x8b\x08\0\0\0\0\0\0\xff", 10);  // of gzip: no name, no time, no system

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
    auto* bgr = o.intensityImage.ptrLine<std::uint8_t>(v);
    for (unsigned u = 0; u < o.cameraParams.ncols; ++u, ++i) {
      o.rangeImage(v, u) = internal::millimetres(frame.depth_m[i]);
      *bgr++ = frame.colour[i].b;
      *bgr++ = frame.colour[i].g;
      *bgr++ = frame.colour[i].r;
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
  o.AIN_32bits.reserve(frame.depth_m.size());
  for (const float depth : frame.depth_m) o.AIN_32bits.push_back(internal::rest(depth, internal::millimetres(depth)));
  return o;
}

}  // namespace

struct RawlogWriter::State {
  using Archive = mrpt::serialization::CArchive;
  using Item = std::function<void(Archive&)>;

  std::filesystem::path path;
  Eigen::Isometry3d T_base_laser;
  bool for_replay = false;
  Stamp now, next_flush;
  std::ofstream file;
  std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor{
      libdeflate_alloc_compressor(kCompression), &libdeflate_free_compressor};
  std::string room;
  Batches<Item> batches;  // the last member, so that it ends before what it works on

  State(const std::filesystem::path& where, const Transform<Base, Laser>& laser, bool threaded)
      : path(where),
        T_base_laser(laser.T),
        file(where, std::ios::binary | std::ios::trunc),
        batches([this](const auto& batch) { write(batch); }, threaded) {
    file << kMemberHead;
    check();
    mrpt::img::CImage::DISABLE_JPEG_COMPRESSION(false);  // MRPT's own default is pixels as they are
    mrpt::img::CImage::SERIALIZATION_JPEG_QUALITY(kJpegQuality);
  }
  void put(const robot::Observation& observation) {
    batches.add([this, observation](Archive& archive) {
      archive << odometry_of(observation.odometry);
      if (observation.scan) archive << scan_of(*observation.scan, T_base_laser);
      if (observation.frame) archive << frame_of(*observation.frame);
      if (!for_replay) return;
      if (observation.frame) archive << rest_of(observation.frame->frame);
      archive << data_of(kObservation, observation.stamp, observation_message(observation));
    });
  }
  void put(const std::string& label, const std::string& bytes) {
    batches.add([label, bytes, stamp = now](Archive& archive) { archive << data_of(label, stamp, bytes); });
  }
  void write(const std::vector<Item>& batch) {
    mrpt::io::CMemoryStream bytes;
    auto archive = mrpt::serialization::archiveFrom(bytes);
    for (const Item& item : batch) item(archive);
    end_member(bytes.getRawBufferData(), bytes.getTotalBytesCount());
    file << kMemberHead << std::flush;
    check();
  }
  /// Members of a gzip file follow one another and are read as one stream. The head of the next one stands there
  /// already, so that a file that was not closed breaks off in the middle of a member.
  void end_member(const void* bytes, std::size_t size) {
    const std::size_t most = libdeflate_deflate_compress_bound(compressor.get(), size);
    if (most > room.size()) room.resize(most);
    const std::size_t packed = libdeflate_deflate_compress(compressor.get(), bytes, size, room.data(), room.size());
    file.write(room.data(), static_cast<std::streamsize>(packed));
    std::string tail;
    internal::put(tail, libdeflate_crc32(0, bytes, size));
    internal::put(tail, static_cast<std::uint32_t>(size));
    file << tail;
  }
  void close() {
    batches.hand_over();
    batches.join();
    end_member("", 0);
    file.close();
    check();
  }
  void check() const {
    if (!file) throw std::runtime_error(path.string() + ": cannot be written");
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
  state_->now = observation.stamp;
  if (state_->now >= state_->next_flush) {
    while (state_->next_flush <= state_->now) state_->next_flush += kBatchPeriod;
    state_->batches.hand_over();
  }
  state_->put(observation);
}

void RawlogWriter::attach(mission::Sinks& sinks) {
  internal::tell_decisions(
      sinks, [this](const char* topic, const char*, const std::string& message) { state_->put(topic, message); });
}

void RawlogWriter::close() { state_->close(); }

}  // namespace amiss::recording
