// The project's own worlds load whole.
#include "files_for_test.hpp"
#include "world/loader.hpp"

namespace amiss::world {
namespace {

TEST(OwnWorldsTest, EveryWorldOfTheProjectLoadsWithoutWarnings) {
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
    ++loaded;
  }
  EXPECT_GE(loaded, 2U);
}

}  // namespace
}  // namespace amiss::world
