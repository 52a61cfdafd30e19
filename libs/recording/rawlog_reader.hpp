// Reads a rawlog object by object, with distrust: the classes and versions that a RawlogWriter has MRPT write, by a
// parser of our own (MRPT's allocates what a broken file tells it to). A file that breaks off is read up to there.
//
// in: rawlog, gzipped or not     out: scans, depth images, named data in the order of the file
// InputError names file, place and what is wrong: an object of another class or version, numbers that make no sense,
// packed data that was damaged.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/sensors.hpp"

namespace amiss::recording {

struct RawlogOdometry {};  // a replay has it more precisely from the data
struct RawlogScan {
  std::vector<float> ranges_m;  // NaN where nothing came back
};
struct RawlogFrame {
  CameraIntrinsics camera;
  std::vector<std::uint16_t> depth_mm;  // width * height, 0 where nothing came back
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
