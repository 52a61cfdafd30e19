// A file that one process holds at a time; free again when the process is gone, however it ended. Where the file system
// knows no locks everybody gets it.
#pragma once

#include <filesystem>
#include <optional>

namespace amiss::experiment {

class FileLock {
 public:
  /// Makes the file; it is removed at the end. Nothing when somebody else holds it; std::runtime_error when the file
  /// cannot be made.
  [[nodiscard]] static std::optional<FileLock> take(const std::filesystem::path& file);
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock(const FileLock&) = delete;
  FileLock& operator=(FileLock&&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  FileLock(std::filesystem::path file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}

  std::filesystem::path file_;
  int descriptor_;
};

}  // namespace amiss::experiment
