// Reads a rawlog object by object, with distrust: the classes and versions that a RawlogWriter has MRPT write, and
// depth cameras of MRPT 1.9 to 2.x, by a parser of our own (MRPT's allocates what a broken file tells it to). A file
// that breaks off is read up to there.
//
// in: rawlog, gzipped or not     out: odometry, scans, depth images, named data in the order of the file
// InputError names file, place and what is wrong: an object of another class or version (no object says how long it is,
// so none can be skipped), numbers that make no sense, packed data that was damaged.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/frames.hpp"
#include "core/sensors.hpp"

namespace amiss::recording {

/// Times are whole microseconds since 1970.
struct RawlogOdometry {
  Stamp stamp;
  Pose2<Odom, Base> T_odom_base;
};
struct RawlogScan {
  std::vector<float> ranges_m;  // NaN where nothing came back
};
/// A picture as the file has it.
struct RawlogPicture {
  int width = 0, height = 0;
  bool is_jpeg = false;
  std::string bytes;  // blue, green, red of each pixel where it is no JPEG
};
struct RawlogFrame {
  Stamp stamp;
  CameraIntrinsics camera;  // of the depth
  float depth_unit_m = 0.001F;
  bool along_rays = false;           // distances from the camera instead of depths
  std::vector<std::uint16_t> depth;  // width * height units, 0 where nothing came back
  Transform<Base, Camera> T_base_camera;
  std::optional<RawlogPicture> colour;
  CameraIntrinsics colour_camera;
  Eigen::Isometry3d T_camera_colour = Eigen::Isometry3d::Identity();  // both look along z
};
/// CObservationRawDAQ.
struct RawlogData {
  std::string label, bytes;
  std::vector<std::uint32_t> numbers;
};
using RawlogObject = std::variant<RawlogOdometry, RawlogScan, RawlogFrame, RawlogData>;

class RawlogReader {
 public:
  explicit RawlogReader(const std::filesystem::path& file);
  ~RawlogReader();
  RawlogReader(const RawlogReader&) = delete;
  RawlogReader& operator=(const RawlogReader&) = delete;

  /// Nothing at the end.
  std::optional<RawlogObject> next();
  /// At the end: did the file have its own end?
  [[nodiscard]] bool complete() const { return complete_; }

 private:
  class Parser;
  std::unique_ptr<Parser> parser_;
  bool over_ = false, complete_ = false;
};

}  // namespace amiss::recording
