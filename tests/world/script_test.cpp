#include "world/script.hpp"

#include <gtest/gtest.h>

#include <set>

namespace amiss::world {
namespace {

TEST(Script, TellsEachChange) {
  EXPECT_EQ(to_string(Change(AddBody{"mug", "my_mug", {1.2, 3.0, {}, 0.0}})), "my_mug appears at (1.20, 3.00)");
  EXPECT_EQ(to_string(Change(MoveBody{"chair_1", {0.5, -1.0, {}, 0.0}})), "chair_1 is moved to (0.50, -1.00)");
  EXPECT_EQ(to_string(Change(RemoveBody{"mug"})), "mug is taken away");
  EXPECT_EQ(to_string(Change(CloseDoor{"leaf", "frame"})), "leaf is closed in frame");
  EXPECT_EQ(to_string(Change(Walk{"anna", {{0, 0}, {1, 0}, {2, 1}}, 0.8})),
            "anna walks from (0.00, 0.00) to (2.00, 1.00)");
  EXPECT_EQ(to_string(Change(Kidnap{{2.0, 1.0, 0.0}})), "the robot is carried to (2.00, 1.00)");
  EXPECT_EQ(to_string(Change(Fault{Sensor::kLaser, FaultKind::kStuck, 1.0, 0.0, {}})), "laser is stuck");
}

TEST(Script, NamesAreDistinct) {
  std::set<std::string_view> names;
  for (const auto kind : {FaultKind::kOff, FaultKind::kStuck, FaultKind::kGarbage, FaultKind::kWrong, FaultKind::kSlow,
                          FaultKind::kDelayed, FaultKind::kIntermittent, FaultKind::kJump}) {
    names.insert(to_string(kind));
  }
  for (const auto sensor : {Sensor::kCamera, Sensor::kLaser, Sensor::kOdometry}) names.insert(to_string(sensor));
  EXPECT_EQ(names.size(), 11U);
  EXPECT_FALSE(names.contains(""));
}

}  // namespace
}  // namespace amiss::world
