// Where data that others made lies; tests skip when it is not there.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace amiss::mapping {

[[nodiscard]] inline std::filesystem::path test_data() {
  const char* elsewhere = std::getenv("AMISS_TEST_DATA");
  return elsewhere != nullptr ? std::filesystem::path(elsewhere)
                              : std::filesystem::path(AMISS_SOURCE_DIR).parent_path() / "shared" / "data";
}

/// A folder of its own for files, gone when the test ends.
class TestFolder {
 public:
  TestFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "amiss-mapping-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::filesystem::filesystem_error("mkdtemp", {});
    path_ = name;
  }
  ~TestFolder() { std::filesystem::remove_all(path_); }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace amiss::mapping
