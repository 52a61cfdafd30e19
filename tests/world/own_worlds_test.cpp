// The project's own worlds load whole, and classes.yaml knows all that stands in them.
#include "files_for_test.hpp"
#include "world/bounds.hpp"
#include "world/class_table.hpp"
#include "world/loader.hpp"

namespace amiss::world {
namespace {

TEST(OwnWorldsTest, EveryWorldOfTheProjectLoadsWithoutWarningsAndEveryBodyHasAClass) {
  const std::filesystem::path folder = std::filesystem::path(AMISS_SOURCE_DIR) / "sim_worlds";
  std::size_t loaded = 0;
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".sdf") continue;
    ::testing::internal::CaptureStderr();
    const World world = load_world(entry.path());
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << entry.path();
    EXPECT_TRUE(world.warnings.empty()) << world.warnings.front();
    EXPECT_TRUE(world.robot_start.has_value()) << entry.path();
    EXPECT_GT(world.bodies.size(), 10U) << entry.path();
    const ClassTable classes = class_table_beside(world);
    for (const Body& body : world.bodies) {
      const bool has_none = classes.class_of(body.name) == SemanticClass::kUnlabelled;
      EXPECT_EQ(has_none, body.name == "ceiling") << entry.path() << ": " << body.name;
    }
    ++loaded;
  }
  EXPECT_GE(loaded, 7U);
}

TEST(OwnWorldsTest, TheRoomsOfTheDataSetHaveSmallThingsOfTheirOwnOnTheirFurniture) {
  const std::filesystem::path folder = std::filesystem::path(AMISS_SOURCE_DIR) / "sim_worlds";
  for (const char* name : {"big_room", "small_room", "living_area", "office_desk", "kitchen_counter"}) {
    const World world = load_world(folder / (std::string(name) + ".sdf"));
    EXPECT_EQ(world.name, name);
    int on_furniture = 0;
    for (const Body& body : world.bodies) {
      const Eigen::AlignedBox3d box = bounds_in_world(body);
      EXPECT_TRUE(body.is_static) << body.name;
      if (!box.isEmpty() && box.min().z() > 0.3 && box.max().z() < 1.4 && box.sizes().maxCoeff() < 0.75) ++on_furniture;
    }
    EXPECT_GE(on_furniture, 3) << name;
  }
}

}  // namespace
}  // namespace amiss::world
