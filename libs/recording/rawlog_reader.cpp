#include "recording/rawlog_reader.hpp"

#include <limits>

#include "core/result.hpp"
#include "recording/internal/exact_depth.hpp"
#include "recording/internal/gz_bytes.hpp"

namespace amiss::recording {

namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 28U;  // of a string or a list
constexpr std::uint32_t kMostPixels = 1U << 24U, kMostBeams = 1U << 16U;
constexpr std::uint8_t kEndOfObject = 0x88, kNameFlag = 0x80;
constexpr std::size_t kPose2Numbers = 3, kPose3Numbers = 12, kDistortions = 8;

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
    if (is("mrpt::obs::CObservation3DRangeScan", 10)) return ended(frame());
    if (is("mrpt::obs::CObservationRawDAQ", 0)) return ended(data());
    if (!type.starts_with("mrpt::")) refuse("is no object of MRPT");
    refuse("a " + type + " of version " + std::to_string(version) + " is not read");
  }

 private:
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
  void pose(const char* type, std::uint8_t version, std::size_t numbers) {
    member(type, version, version);
    bytes_.take(numbers * sizeof(double));
    end_member();
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
    pose("mrpt::poses::CPose2D", 1, kPose2Numbers);
    text();
    bytes_.take(sizeof(std::int64_t));
    none("counts of encoders");
    none("velocities");
    return RawlogOdometry{};
  }
  RawlogObject scan() {
    bytes_.take(2 * sizeof(float) + 1);  // aperture, direction, most range
    pose("mrpt::poses::CPose3D", 3, kPose3Numbers);
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
  RawlogObject frame() {
    bytes_.take(sizeof(float));
    pose("mrpt::poses::CPose3D", 3, kPose3Numbers);
    none("points");
    if (!flag()) refuse("has no depth");
    if (bytes_.number<float>() != internal::kDepthUnitM) refuse("its depth is not in millimetres");
    const auto rows = bytes_.number<std::uint32_t>(), columns = bytes_.number<std::uint32_t>();
    if (rows == 0 || columns == 0 || rows > kMostPixels / columns) refuse("has no or too many pixels");
    RawlogFrame frame;
    frame.depth_mm = list<std::uint16_t>(std::uint64_t{rows} * columns);
    if (flag()) colours();
    none("a picture of confidence");
    frame.camera = camera();
    camera();
    frame.camera.width = static_cast<int>(columns);
    frame.camera.height = static_cast<int>(rows);
    pose("mrpt::poses::CPose3D", 3, kPose3Numbers);
    bytes_.take(sizeof(float) + sizeof(std::int64_t));
    text();
    for (int i = 0; i < 2; ++i) {
      none("parts in other files");
      text();
    }
    bytes_.take(2);  // depth or range, the kind of picture
    none("labels");
    none("further layers");
    return frame;
  }
  /// As they are or as JPEG; a replay has the colours that it needs from the data.
  void colours() {
    member("mrpt::img::CImage", 9, 9);
    none("a picture in another file");
    if (!flag()) refuse("its picture has no colours");
    const auto width = bytes_.number<std::int32_t>(), height = bytes_.number<std::int32_t>();
    if (width > 0 && height > 0) {
      text();
    } else {  // negative sizes say that they are as they are
      const std::int64_t pixels = std::int64_t{width} * height;
      if (width >= 0 || height >= 0 || pixels > kMostPixels) refuse("its picture has no or too many pixels");
      bytes_.take(static_cast<std::uint64_t>(pixels) * sizeof(Rgb));
    }
    end_member();
  }
  CameraIntrinsics camera() {
    member("mrpt::img::TCamera", 5, 6);
    bytes_.take((1 + kDistortions) * sizeof(double));
    CameraIntrinsics camera;
    camera.fx = bytes_.number<double>();
    camera.fy = bytes_.number<double>();
    camera.cx = bytes_.number<double>();
    camera.cy = bytes_.number<double>();
    bytes_.take(2 * sizeof(std::uint32_t));
    text();
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
