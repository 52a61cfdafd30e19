#include "recording/source.hpp"

#include <fstream>

#include "core/result.hpp"
#include "recording/bag_source.hpp"
#include "recording/rawlog_recording.hpp"
#include "recording/recording.hpp"

namespace amiss::recording {

std::unique_ptr<Source> open_source(const std::filesystem::path& file, const BagSetting& setting) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) throw InputError(file.string() + ": is a folder; a file is needed");
  if (!std::filesystem::is_regular_file(file, error)) throw InputError(file.string() + ": there is no such file");
  std::string begin(8, '\0');
  std::ifstream(file, std::ios::binary).read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (begin.starts_with("\x89MCAP0\r\n")) return std::make_unique<Recording>(file);
  if (begin.starts_with("\x1f\x8b") || begin.substr(1, 6) == "mrpt::") return std::make_unique<RawlogRecording>(file);
  if (dataset::RobotBag::is_bag(file)) return std::make_unique<BagSource>(file, setting.bag, setting.T_map_base);
  throw InputError(file.string() + ": is no MCAP file, no rawlog and no ROS 1 bag of format 2.0 (it begins otherwise)");
}

}  // namespace amiss::recording
