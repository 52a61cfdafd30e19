// Files that amiss writes, in the readers of others. README.md is the table; a reader that is not installed is skipped.
#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <array>
#include <cstdio>

#include "core/random.hpp"
#include "core/temporary_folder.hpp"
#include "dataset/cloud_files.hpp"
#include "mapping/floor_grid_files.hpp"
#include "mapping/voxel_files.hpp"

namespace amiss {
namespace {

struct Said {
  int status = 0;
  std::string text;
};

/// What a shell command says on both of its outputs.
Said run(const std::string& command) {
  Said said;
  FILE* pipe = ::popen((command + " 2>&1 </dev/null").c_str(), "r");
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) said.text += buffer.data();
  const int status = ::pclose(pipe);
  said.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return said;
}

bool installed(const std::string& program) { return run("command -v " + program).status == 0; }

mapping::VoxelMap some_map() {
  mapping::VoxelMap map;
  RandomStream random(1, "voxels");
  for (int i = 0; i < 500; ++i) {
    const auto any = [&] { return static_cast<int>(random.below(60)) - 30; };
    map.set({any(), any(), any()}, i % 3 == 0 ? Occupancy::kOccupied : Occupancy::kFree);
  }
  return map;
}

dataset::CloudFile some_cloud() {
  dataset::CloudFile file;
  Cloud<Map>& cloud = file.mesh.vertices;
  for (int i = 0; i < 100; ++i) {
    cloud.points.emplace_back(0.01F * static_cast<float>(i), -1.0F, 0.5F);
    cloud.colours.push_back({255, static_cast<std::uint8_t>(i), 0});
    cloud.normals.emplace_back(0.0F, 0.0F, 1.0F);
  }
  dataset::ScalarField label{"label", {}};
  for (int i = 0; i < 100; ++i) label.values.push_back(i % 4);
  file.fields.push_back(label);
  return file;
}

struct OctoMapTools : testing::TestWithParam<const char*> {};

TEST_P(OctoMapTools, ReadTheVoxelMap) {
  if (!installed("convert_octree")) GTEST_SKIP() << "octomap-tools is not installed";
  const test::TemporaryFolder folder;
  const mapping::VoxelMap map = some_map();
  const std::string from = folder.path() / (std::string("map.") + GetParam()), to = folder.path() / "again.ot";
  mapping::save_voxel_map(from, map);
  const Said said = run("convert_octree '" + from + "' '" + to + "'");
  ASSERT_EQ(said.status, 0) << said.text;
  const mapping::VoxelMap again = mapping::load_voxel_map(to);
  EXPECT_EQ(again.voxels(Occupancy::kOccupied), map.voxels(Occupancy::kOccupied));
  EXPECT_EQ(again.voxels(Occupancy::kFree), map.voxels(Occupancy::kFree));
}
INSTANTIATE_TEST_SUITE_P(Formats, OctoMapTools, testing::Values("ot", "bt"));

struct ThreeLoaders : testing::TestWithParam<std::pair<const char*, dataset::CloudFormat>> {};

TEST_P(ThreeLoaders, ReadTheCloud) {
  const auto& [extension, format] = GetParam();
  if (!installed("node")) GTEST_SKIP() << "node is not installed";
  const test::TemporaryFolder folder;
  const std::string file = folder.path() / (std::string("cloud.") + extension);
  dataset::save_cloud(file, some_cloud(), format);
  const Said said = run("node '" AMISS_SOURCE_DIR "/tests/formats/read_cloud.mjs' '" + file + "'");
  if (said.status == 77) GTEST_SKIP() << "three is not installed (npm ci in share/web)";
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_EQ(said.text, "points 100\nposition 49.500 -100.000 50.000\nnormal 0.000 0.000 100.000\ncoloured true\n");
}
INSTANTIATE_TEST_SUITE_P(Formats, ThreeLoaders,
                         testing::Values(std::pair{"ply", dataset::CloudFormat::kAscii},
                                         std::pair{"ply", dataset::CloudFormat::kBinary},
                                         std::pair{"pcd", dataset::CloudFormat::kAscii},
                                         std::pair{"pcd", dataset::CloudFormat::kBinary}));

TEST(Formats, CheckUrdfReadsTheRobot) {
  if (!installed("check_urdf")) GTEST_SKIP() << "liburdfdom-tools is not installed";
  const Said said = run("check_urdf '" AMISS_SOURCE_DIR "/robot_model/hsr.urdf'");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_NE(said.text.find("robot name is: hsr"), std::string::npos) << said.text;
  EXPECT_EQ(said.text.find("rror"), std::string::npos) << said.text;
}

TEST(Formats, MrptReadsTheFloor) {
  const test::TemporaryFolder folder;
  FloorGrid grid(0.05, {-1.0, 2.0}, 30, 20, Occupancy::kFree);
  for (int x = 0; x < 30; ++x) grid.set({x, 4}, Occupancy::kOccupied);
  grid.set({7, 9}, Occupancy::kUnknown);
  mapping::save_floor_grid(folder.path() / "map.yaml", grid);
  mrpt::maps::COccupancyGridMap2D read;
  ASSERT_TRUE(read.loadFromROSMapServerYAML(folder.path() / "map.yaml"));
  EXPECT_NEAR(read.getResolution(), 0.05, 1e-6);
  ASSERT_GE(read.getSizeX(), 30U);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 30; ++x) {
      const Eigen::Vector2d p = grid.centre_of({x, y});
      const float free = read.getPos(static_cast<float>(p.x()), static_cast<float>(p.y()));
      const Occupancy value = grid.at(Cell{x, y});
      if (value == Occupancy::kOccupied) {
        EXPECT_LT(free, 0.35F) << x << " " << y;
      }
      if (value == Occupancy::kFree) {
        EXPECT_GT(free, 0.8F) << x << " " << y;
      }
      if (value == Occupancy::kUnknown) {
        EXPECT_NEAR(free, 0.5F, 0.31F) << x << " " << y;
      }
    }
  }
}

}  // namespace
}  // namespace amiss
