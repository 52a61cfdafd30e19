#include "world/fingerprint.hpp"

#include "files_for_test.hpp"
#include "world/loader.hpp"

namespace amiss::world {
namespace {

class FingerprintOf : public FilesForTest {
 protected:
  std::string of(const std::string& file, const std::string& content) const {
    return fingerprint(load_world(write(file, world_text(content))));
  }
};

TEST_F(FingerprintOf, ContentCountsNotTheFile) {
  const std::string box = box_model("b", "1 2 3");
  EXPECT_EQ(of("a.sdf", box).size(), 64U);
  EXPECT_EQ(of("a.sdf", box), of("folder/other.sdf", "<!-- the same -->" + box));
}

TEST_F(FingerprintOf, WhatTheRobotMayMeetCounts) {
  const std::string plain = of("a.sdf", box_model("b", "1 2 3"));
  EXPECT_NE(of("b.sdf", box_model("b", "1 2 3.001")), plain) << "size";
  EXPECT_NE(of("b.sdf", box_model("b", "1 2 3", "<pose>0 0 0.1 0 0 0</pose>")), plain) << "place";
  EXPECT_NE(of("b.sdf", box_model("b", "1 2 3", "<static>true</static>")), plain) << "fixed or not";
  EXPECT_NE(of("b.sdf", box_model("b", "1 2 3") + box_model("c", "1 1 1")), plain) << "another body";
  EXPECT_NE(of("b.sdf", box_model("b", "1 2 3") + "<frame name='robot_start'><pose>1 0 0 0 0 0</pose></frame>"), plain)
      << "the robot's start";
}

}  // namespace
}  // namespace amiss::world
