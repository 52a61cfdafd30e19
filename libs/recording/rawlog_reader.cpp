#include "recording/rawlog_reader.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "core/result.hpp"
#include "recording/internal/gz_bytes.hpp"

namespace amiss::recording {

namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 28U;  // of a string or a list
constexpr std::uint32_t kMostPixels = 1U << 24U, kMostBeams = 1U << 16U;
constexpr std::uint8_t kEndOfObject = 0x88, kNameFlag = 0x80;
constexpr std::size_t kDistortions = 8;
constexpr std::int64_t kTicksTo1970 = 116'444'736'000'000'000, kTicksPerMicrosecond = 10;  // of MRPT's clock
constexpr std::int64_t kMostTicks = 90'000'000'000'000'000;                                // since 1970
constexpr double kNotRigid = 1e-3;

/// MRPT's depth cameras look along x, z up.
Eigen::Isometry3d body_from_optical() {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return T;
}

}  // namespace

class RawlogReader::Parser {
 public:
  explicit Parser(const std::filesystem::path& file) : name_(file.string()), bytes_(file) {}

  bool at_end() { return bytes_.at_end(); }

  RawlogObject object() {
    at_ = bytes_.at();
    const auto flagged = bytes_.number<std::uint8_t>();
    if (flagged <= kNameFlag) refuse("is no object of MRPT");
    const std::string type = bytes_.take(flagged - kNameFlag);
    const auto version = bytes_.number<std::uint8_t>();
    const auto is = [&](const char* wanted, std::uint8_t known) { return type == wanted && version == known; };
    if (is("mrpt::obs::CObservationOdometry", 2)) return ended(odometry());
    if (is("mrpt::obs::CObservation2DRangeScan", 7)) return ended(scan());
    if (is("mrpt::obs::CObservation3DRangeScan", 9) || is("mrpt::obs::CObservation3DRangeScan", 10)) {
      return ended(frame(version));
    }
    if (is("mrpt::obs::CObservationRawDAQ", 0)) return ended(data());
    if (!is_class(type)) refuse("is no object of MRPT");
    refuse("a " + type + " of version " + std::to_string(version) +
           " is not read; CObservationOdometry 2, CObservation2DRangeScan 7, CObservation3DRangeScan 9 and 10 and "
           "CObservationRawDAQ 0 are");
  }

 private:
  /// "mrpt::obs::CSensoryFrame", or without its namespaces as MRPT 1 wrote it.
  static bool is_class(const std::string& type) {
    const auto is_part_of_name = [](unsigned char c) { return std::isalnum(c) != 0 || c == ':' || c == '_'; };
    return (type.starts_with("mrpt::") || type.starts_with('C')) &&
           std::all_of(type.begin(), type.end(), is_part_of_name);
  }
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(name_ + ": object at byte " + std::to_string(at_) + " (unpacked): " + what);
  }
  RawlogObject ended(RawlogObject object) {
    if (bytes_.number<std::uint8_t>() != kEndOfObject) refuse("is longer than it should be");
    return object;
  }
  /// The head of an object inside of another.
  void member(const std::string& type, std::uint8_t oldest, std::uint8_t newest) {
    const auto flagged = bytes_.number<std::uint8_t>();
    const std::string found = flagged <= kNameFlag ? "" : bytes_.take(flagged - kNameFlag);
    const auto version = bytes_.number<std::uint8_t>();
    if (found != type || version < oldest || version > newest) refuse("has no " + type + " where it should");
    member_version_ = version;
  }
  void end_member() {
    if (bytes_.number<std::uint8_t>() != kEndOfObject) refuse("a part of it is longer than it should be");
  }
  Eigen::Isometry3d pose3() {
    member("mrpt::poses::CPose3D", 3, 3);
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    for (int i = 0; i < 3; ++i) T.translation()[i] = bytes_.number<double>();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) T.linear()(row, column) = bytes_.number<double>();
    }
    end_member();
    const double off = (T.linear().transpose() * T.linear() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (!T.matrix().allFinite() || !(off < kNotRigid) || T.linear().determinant() < 0.0) {
      refuse("a pose of it is no rigid motion");
    }
    return T;
  }
  Stamp time() {
    const std::int64_t ticks = bytes_.number<std::int64_t>();
    if (ticks < kTicksTo1970 || ticks - kTicksTo1970 > kMostTicks) refuse("its time is none after 1970");
    // Rounded: MRPT cuts off what it makes of a number of seconds.
    const std::int64_t microseconds = (ticks - kTicksTo1970 + kTicksPerMicrosecond / 2) / kTicksPerMicrosecond;
    return Stamp(std::chrono::microseconds(microseconds));
  }
  template <class Number>
  std::vector<Number> list(std::uint64_t count) {
    if (count > kMostBytes / sizeof(Number)) refuse("holds " + std::to_string(count) + " numbers, which is too many");
    const std::string taken = bytes_.take(count * sizeof(Number));
    std::vector<Number> numbers(count);
    if (count > 0) std::memcpy(numbers.data(), taken.data(), taken.size());
    return numbers;
  }
  template <class Number>
  std::vector<Number> list() {
    return list<Number>(bytes_.number<std::uint32_t>());
  }
  std::string text() {
    const auto size = bytes_.number<std::uint32_t>();
    if (size > kMostBytes) refuse("holds a text of " + std::to_string(size) + " bytes, which is too long");
    return bytes_.take(size);
  }
  bool flag() { return bytes_.number<std::uint8_t>() != 0; }
  void none(const char* what) {
    if (flag()) refuse(std::string("holds ") + what + ", which is not read");
  }

  RawlogObject odometry() {
    RawlogOdometry odometry;
    member("mrpt::poses::CPose2D", 1, 1);
    odometry.T_odom_base.x_m = bytes_.number<double>();
    odometry.T_odom_base.y_m = bytes_.number<double>();
    odometry.T_odom_base.yaw_rad = bytes_.number<double>();
    end_member();
    const auto& at = odometry.T_odom_base;
    if (!std::isfinite(at.x_m + at.y_m + at.yaw_rad)) refuse("its pose is not finite");
    text();
    odometry.stamp = time();
    none("counts of encoders");
    none("velocities");
    return odometry;
  }
  RawlogObject scan() {
    bytes_.take(2 * sizeof(float) + 1);  // aperture, direction, most range
    pose3();
    const auto beams = bytes_.number<std::uint32_t>();
    if (beams > kMostBeams) refuse("is a scan of " + std::to_string(beams) + " beams, which is too many");
    RawlogScan scan{list<float>(beams)};
    const std::string valid = bytes_.take(beams);
    for (std::size_t i = 0; i < beams; ++i) {
      if (valid[i] == 0) scan.ranges_m[i] = std::numeric_limits<float>::quiet_NaN();
    }
    bytes_.take(2 * sizeof(float) + sizeof(std::int64_t));  // deviation, time, width of a beam
    text();
    bytes_.take(sizeof(double));
    none("intensities");
    return scan;
  }
  RawlogObject frame(std::uint8_t version) {
    RawlogFrame frame;
    bytes_.take(sizeof(float));
    frame.T_base_camera.T = pose3() * body_from_optical();
    if (flag()) points();
    if (!flag()) refuse("has no depth");
    frame.depth_unit_m = bytes_.number<float>();
    if (!(frame.depth_unit_m > 0.0F && frame.depth_unit_m < 1.0F)) refuse("the unit of its depth makes no sense");
    const auto rows = bytes_.number<std::uint32_t>(), columns = bytes_.number<std::uint32_t>();
    if (rows == 0 || columns == 0 || rows > kMostPixels / columns) refuse("has no or too many pixels");
    frame.depth = list<std::uint16_t>(std::uint64_t{rows} * columns);
    if (flag()) frame.colour = colours();
    none("a picture of confidence");
    frame.camera = camera();
    frame.colour_camera = camera();
    frame.camera.width = static_cast<int>(columns);
    frame.camera.height = static_cast<int>(rows);
    frame.T_camera_colour = body_from_optical().inverse() * pose3();
    bytes_.take(sizeof(float));
    frame.stamp = time();
    text();
    for (int i = 0; i < 2; ++i) {
      none("parts in other files");
      text();
    }
    frame.along_rays = !flag();
    bytes_.take(1);  // the kind of picture
    none("labels");
    if (version > 9) none("further layers");
    return frame;
  }
  /// They are in the depth image once more.
  void points() {
    const auto count = bytes_.number<std::uint32_t>();
    if (count > kMostPixels) refuse("has " + std::to_string(count) + " points, which is too many");
    bytes_.take(std::uint64_t{count} * (3 * sizeof(float) + 2 * sizeof(std::uint16_t)));
  }
  /// As they are or as JPEG.
  RawlogPicture colours() {
    member("mrpt::img::CImage", 9, 9);
    none("a picture in another file");
    if (!flag()) refuse("its picture has no colours");
    RawlogPicture picture{bytes_.number<std::int32_t>(), bytes_.number<std::int32_t>(), false, {}};
    picture.is_jpeg = picture.width > 0 && picture.height > 0;
    if (picture.is_jpeg) {
      picture.bytes = text();
    } else {  // negative sizes say that they are as they are
      const std::int64_t pixels = std::int64_t{picture.width} * picture.height;
      if (picture.width >= 0 || picture.height >= 0 || pixels > kMostPixels) {
        refuse("its picture has no or too many pixels");
      }
      picture.bytes = bytes_.take(static_cast<std::uint64_t>(pixels) * sizeof(Rgb));
      picture.width = -picture.width;
      picture.height = -picture.height;
    }
    end_member();
    return picture;
  }
  CameraIntrinsics camera() {
    member("mrpt::img::TCamera", 4, 6);
    bytes_.take((1 + kDistortions) * sizeof(double));
    CameraIntrinsics camera;
    camera.fx = bytes_.number<double>();
    camera.fy = bytes_.number<double>();
    camera.cx = bytes_.number<double>();
    camera.cy = bytes_.number<double>();
    bytes_.take(2 * sizeof(std::uint32_t));
    if (member_version_ > 4) text();
    if (member_version_ > 5) bytes_.take(1);  // kind of distortion
    end_member();
    return camera;
  }
  RawlogObject data() {
    RawlogData data;
    data.label = text();
    bytes_.take(sizeof(std::int64_t) + sizeof(double));
    data.bytes = text();
    list<std::uint16_t>();
    data.numbers = list<std::uint32_t>();
    list<float>();
    list<double>();
    bytes_.take(sizeof(std::uint16_t) + 1);  // channels, interleaved
    list<std::uint8_t>();
    list<std::uint16_t>();
    list<float>();
    list<double>();
    list<std::uint8_t>();
    list<std::uint8_t>();
    list<std::uint32_t>();
    list<double>();
    return data;
  }

  std::string name_;
  internal::GzBytes bytes_;
  std::uint64_t at_ = 0;  // where the object begins
  std::uint8_t member_version_ = 0;
};

RawlogReader::RawlogReader(const std::filesystem::path& file) : parser_(std::make_unique<Parser>(file)) {}

RawlogReader::~RawlogReader() = default;

std::optional<RawlogObject> RawlogReader::next() {
  if (over_) return std::nullopt;
  try {
    complete_ = parser_->at_end();
    if (!complete_) return parser_->object();
  } catch (const internal::BrokenOff&) {
  }
  over_ = true;
  return std::nullopt;
}

}  // namespace amiss::recording
