// Files that tests write into a folder of their own, and the folder of data that others made.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace amiss::world {

class FilesForTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              ("amiss_" + std::string(info->test_suite_name()) + "_" + info->name() + "_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    const std::filesystem::path file = folder_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  std::filesystem::path folder_;
};

/// Where recordings and worlds of others lie, if they do.
inline std::filesystem::path shared_data() {
  const char* folder = std::getenv("AMISS_TEST_DATA");
  return folder != nullptr ? std::filesystem::path(folder)
                           : std::filesystem::path(AMISS_SOURCE_DIR) / ".." / "shared" / "data";
}

/// A world around `content`.
inline std::string world_text(const std::string& content, const std::string& version = "1.7") {
  return "<?xml version='1.0'?>\n<sdf version='" + version + "'>\n<world name='w'>\n" + content +
         "\n</world>\n</sdf>\n";
}

/// A model of one link with one box.
inline std::string box_model(const std::string& name, const std::string& size, const std::string& more = "") {
  return "<model name='" + name + "'>" + more + "<link name='link'><collision name='c'><geometry><box><size>" + size +
         "</size></box></geometry></collision><visual name='v'><geometry><box><size>" + size +
         "</size></box></geometry></visual></link></model>";
}

inline std::string as_file(const std::string& model, const std::string& version = "1.7") {
  return "<?xml version='1.0'?>\n<sdf version='" + version + "'>" + model + "</sdf>";
}

}  // namespace amiss::world
