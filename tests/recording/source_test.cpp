#include "recording/source.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "recording/small_rawlog.hpp"

namespace amiss::recording {
namespace {

std::string why(const std::filesystem::path& file) {
  return test::sentence_of<InputError>([&] { (void)open_source(file); });
}

TEST(Source, TheFirstBytesTellTheFormat) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(open_source(test::small_rawlog(folder, 1, true))->setup().method, "dynamic");
  const std::string plain = test::unpacked(folder.path() / "a.rawlog");
  EXPECT_EQ(open_source(folder.write("plain", plain))->setup().method, "dynamic");
  EXPECT_NE(why(folder.write("b", "\x89MCAP0\r\n")).find("is no recording of a run"), std::string::npos);
  EXPECT_NE(why(folder.write("c", "\x1f\x8b")).find("does not hold what a replay needs, or breaks off"), std::string::npos);
  EXPECT_NE(why(folder.write("d", "")).find("is no MCAP file, no rawlog and no ROS 1 bag"), std::string::npos);
  EXPECT_NE(why(folder.write("f", "#ROSBAG V2.0\n")).find("has no topic '/hsrb/odom'"), std::string::npos);
  EXPECT_NE(why(folder.path()).find("is a folder; a file is needed"), std::string::npos);
  EXPECT_NE(why(folder.path() / "e").find("there is no such file"), std::string::npos);
}

}  // namespace
}  // namespace amiss::recording
