#include "world/room_plan.hpp"

#include <numeric>

#include "core/result.hpp"
#include "files_for_test.hpp"

namespace amiss::world {
namespace {

class RoomPlanTest : public FilesForTest {};

TEST_F(RoomPlanTest, TheDataSetHasFiveRoomsThirtyOneVisitsAndTwoHundredSixtyObjects) {
  const auto plans = load_room_plans(std::filesystem::path(AMISS_SOURCE_DIR) / "sim_worlds" / "dataset.yaml");
  ASSERT_EQ(plans.size(), 5U);
  std::size_t visits = 0;
  int objects = 0;
  for (const RoomPlan& plan : plans) {
    visits += 1 + plan.objects.size();
    objects += std::accumulate(plan.objects.begin(), plan.objects.end(), 0);
    EXPECT_GE(*std::min_element(plan.objects.begin(), plan.objects.end()), 3) << plan.world;
    EXPECT_LE(*std::max_element(plan.objects.begin(), plan.objects.end()), 18) << plan.world;
    EXPECT_GE(plan.waypoints.size(), 5U) << plan.world;
  }
  EXPECT_EQ(visits, 31U);
  EXPECT_EQ(objects, 260);
}

TEST_F(RoomPlanTest, NumbersAreReadAndWrongFilesRefusedWithTheirLine) {
  const auto read = [&](const std::string& text) { return load_room_plans(write("dataset.yaml", text)); };
  const auto why = [&](const std::string& text) -> std::string {
    try {
      static_cast<void>(read(text));
    } catch (const InputError& error) {
      return std::string(error.what()).substr((folder_ / "dataset.yaml").string().size());
    }
    return "";
  };
  const auto plans = read("den: {objects: [1, 0], lift: 0.2, waypoints: [[1, 2.5, -90]]}\n");
  ASSERT_EQ(plans.size(), 1U);
  EXPECT_EQ(plans[0].world, "den");
  EXPECT_EQ(plans[0].objects, (std::vector<int>{1, 0}));
  EXPECT_EQ(plans[0].lift_m, 0.2);
  EXPECT_EQ(plans[0].waypoints[0].y_m, 2.5);
  EXPECT_NEAR(plans[0].waypoints[0].yaw_rad, radians(-90.0), 1e-12);
  EXPECT_EQ(why("den: {objects: [1], waypoints: [[1, 2]]}\n"), ":1: a waypoint is [x, y, heading in degrees]");
  EXPECT_EQ(why("den:\n  objects: [few]\n  waypoints: [[1, 2, 3]]\n"),
            ":2: objects are whole numbers from 0 to 100");
  EXPECT_EQ(why("den: {objects: [1]}\n"), ":1: waypoints is not a list with at least one entry");
  EXPECT_EQ(why("[den]\n"), ":1: not a map; allowed is WORLD: {objects: [..], ..}");
}

}  // namespace
}  // namespace amiss::world
