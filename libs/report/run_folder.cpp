#include "report/run_folder.hpp"

#include "core/files.hpp"
#include "core/result.hpp"

namespace amiss::report {

namespace {

std::string status_of(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "status";
  return std::filesystem::is_regular_file(file) ? load_bytes(file, 64) : std::string();
}

}  // namespace

RunFolder::RunFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  if (std::filesystem::exists(folder_, error) && !std::filesystem::is_directory(folder_, error)) {
    throw ArgumentError(folder_.string() + ": is a file; a folder that is new or empty is allowed for --out");
  }
  std::filesystem::create_directories(folder_, error);
  if (error) throw ArgumentError(folder_.string() + ": cannot be made (" + error.message() + ")");
  if (!std::filesystem::is_empty(folder_)) {
    const std::string status = status_of(folder_);
    if (status != "running\n" && status != "interrupted\n") {
      throw ArgumentError(folder_.string() +
                          ": holds something else; a folder that is new, empty or of an unfinished " +
                          "run is allowed for --out");
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) std::filesystem::remove_all(entry);
  }
  save("status", "running\n");
}

void RunFolder::save(const std::filesystem::path& name, std::string_view bytes) const {
  const std::filesystem::path file = folder_ / name;
  std::filesystem::create_directories(file.parent_path());
  save_atomically(file, bytes);
}

void RunFolder::finish(std::string_view report_json) const {
  save("report.json", report_json);
  save("status", "finished\n");
}

void RunFolder::interrupt(std::string_view report_json) const {
  save("report.partial.json", report_json);
  save("status", "interrupted\n");
}

std::filesystem::path unused_folder(const std::filesystem::path& parent, const std::string& stem) {
  std::filesystem::path folder = parent / stem;
  for (int i = 2; std::filesystem::exists(folder); ++i) folder = parent / (stem + "-" + std::to_string(i));
  return folder;
}

}  // namespace amiss::report
