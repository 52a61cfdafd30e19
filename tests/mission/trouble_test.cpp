#include "mission/trouble.hpp"

#include <gtest/gtest.h>

#include <set>

namespace amiss::mission {
namespace {

TEST(Trouble, SaysWhatIsWrong) {
  EXPECT_EQ(to_string(Trouble{Sense::kLaser, Complaint::kStuck, {}}), "laser stuck");
  EXPECT_EQ(to_string(Trouble{Sense::kCamera, Complaint::kSilent, {}}), "camera silent");
  EXPECT_EQ(to_string(Trouble{Sense::kOdometry, Complaint::kGarbage, {}}), "odometry garbage");
  EXPECT_EQ(to_string(Trouble{Sense::kPose, Complaint::kLost, {}}), "pose lost");
}

TEST(Trouble, NavigationErrorsHaveAWordEach) {
  std::set<std::string_view> words;
  for (const NavigationError error : kNavigationErrors) words.insert(to_string(error));
  EXPECT_EQ(words.size(), std::size(kNavigationErrors));
  EXPECT_FALSE(words.contains(""));
}

}  // namespace
}  // namespace amiss::mission
