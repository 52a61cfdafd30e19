// The folder that every longer command writes, and which never looks finished when it is not.
// `status` says "running", "interrupted" or "finished"; report.json is there only when finished (else
// report.partial.json). All files are written whole or not at all. ArgumentError when the folder holds something else.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace amiss::report {

class RunFolder {
 public:
  /// Makes the folder (and parents). It must be new, empty, or an earlier run that ended before it was finished, whose
  /// files are then replaced.
  explicit RunFolder(std::filesystem::path folder);

  void save(const std::filesystem::path& name, std::string_view bytes) const;
  void finish(std::string_view report_json) const;
  void interrupt(std::string_view report_json) const;
  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// parent/stem, or parent/stem-2, -3, ... : the first that is not there.
[[nodiscard]] std::filesystem::path unused_folder(const std::filesystem::path& parent, const std::string& stem);

}  // namespace amiss::report
