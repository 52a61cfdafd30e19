#include "mapping/voxel_files.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>
#include <fstream>
#include <map>

#include "core/files.hpp"
#include "core/random.hpp"
#include "core/result.hpp"
#include "mapping/test_data.hpp"

namespace amiss::mapping {
namespace {

VoxelMap random_map(std::uint64_t seed, const std::string& store) {
  VoxelMapParams params;
  params.store = store;
  VoxelMap map(params);
  RandomStream random(seed, "voxel files");
  for (int i = 0; i < 300; ++i) {
    const auto index = [&random] { return static_cast<int>(random.below(40)) - 20; };
    map.set_log_odds({index(), index(), index()}, random.uniform(-2.0, 3.5));
  }
  for (int i = 0; i < 16 * 16 * 16; ++i) map.set({64 + i % 16, i / 16 % 16, i / 256}, Occupancy::kFree);  // is pruned
  return map;
}

bool same_values(const VoxelMap& a, const VoxelMap& b) {
  return a.voxels(Occupancy::kFree) == b.voxels(Occupancy::kFree) &&
         a.voxels(Occupancy::kOccupied) == b.voxels(Occupancy::kOccupied);
}

RC_GTEST_PROP(VoxelFiles, WhatIsWrittenIsRead, ()) {
  const char* store = *rc::gen::element("blocks", "octomap");
  const VoxelMap map = random_map(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1000)), store);
  const VoxelMap plain = parse_voxel_map(voxel_map_bytes(map, VoxelFormat::kOt), "plain");
  RC_ASSERT(same_values(map, plain));
  map.for_each_known([&](Voxel v, Occupancy) { RC_ASSERT(map.log_odds(v) == plain.log_odds(v)); });
  RC_ASSERT(same_values(map, parse_voxel_map(voxel_map_bytes(map, VoxelFormat::kBt), "binary")));
  RC_ASSERT(voxel_map_bytes(plain, VoxelFormat::kOt) == voxel_map_bytes(map, VoxelFormat::kOt));
}

TEST(VoxelFiles, AnEmptyMapSurvives) {
  for (const VoxelFormat format : {VoxelFormat::kOt, VoxelFormat::kBt}) {
    EXPECT_EQ(parse_voxel_map(voxel_map_bytes(VoxelMap{}, format), "empty").counts(), VoxelCounts{});
  }
}

TEST(VoxelFiles, SavesByExtension) {
  const TestFolder folder;
  const VoxelMap map = random_map(1, "blocks");
  save_voxel_map(folder / "m.ot", map);
  save_voxel_map(folder / "m.bt", map);
  EXPECT_EQ(load_bytes(folder / "m.ot"), voxel_map_bytes(map, VoxelFormat::kOt));
  EXPECT_TRUE(same_values(load_voxel_map(folder / "m.bt"), map));
  EXPECT_THROW(save_voxel_map(folder / "m.vdb", map), ArgumentError);
  EXPECT_THROW((void)load_voxel_map(folder / "none.ot"), InputError);
}

std::string error_of(const std::string& bytes) {
  try {
    (void)parse_voxel_map(bytes, "some.ot");
  } catch (const InputError& e) {
    return e.what();
  }
  return {};
}

TEST(VoxelFiles, SaysWhatIsWrong) {
  const std::string good = voxel_map_bytes(random_map(2, "blocks"), VoxelFormat::kOt);
  const auto replaced = [&good](const std::string& from, const std::string& to) {
    std::string bytes = good;
    return bytes.replace(bytes.find(from), from.size(), to);
  };
  EXPECT_EQ(error_of(good), "");
  EXPECT_NE(error_of("").find("not an OctoMap file"), std::string::npos);
  EXPECT_NE(error_of(std::string(100, '\0')).find("not an OctoMap file"), std::string::npos);
  EXPECT_NE(error_of(replaced("id OcTree", "id ColorOcTree")).find("allowed is OcTree"), std::string::npos);
  EXPECT_NE(error_of(replaced("res 0.05", "res nan")).find("0.001 to 10"), std::string::npos);
  EXPECT_NE(error_of(replaced("res 0.05", "res -1")).find("0.001 to 10"), std::string::npos);
  EXPECT_NE(error_of(replaced("size ", "size 9")).find("nodes"), std::string::npos);
  EXPECT_NE(error_of(replaced("size ", "size -")).find("number of nodes"), std::string::npos);
  EXPECT_NE(error_of(replaced("\ndata\n", "\ndatum\n")).find("incomplete"), std::string::npos);
  EXPECT_NE(error_of(good.substr(0, good.size() - 1)).find("more than the file can hold"), std::string::npos);
  EXPECT_NE(error_of(good + "x").find("left over"), std::string::npos);
}

TEST(VoxelFiles, RefusesSpaceWithoutEnd) {
  // One free child of the root: an eighth of everything.
  const std::string bytes =
      "# Octomap OcTree binary file\nid OcTree\nsize 2\nres 0.05\ndata\n" + std::string("\x01\x00", 2);
  EXPECT_NE(error_of(bytes).find("covers more than"), std::string::npos);
}

TEST(VoxelFiles, RefusesValuesThatAreNotNumbersAndInnerNodesThatDoNotFit) {
  VoxelMap map;
  map.set({0, 0, 0}, Occupancy::kOccupied);
  const std::string good = voxel_map_bytes(map, VoxelFormat::kOt);
  std::string bytes = good;
  bytes.replace(bytes.size() - 5, 4, "\xff\xff\xff\x7f", 4);  // the only leaf becomes NaN
  EXPECT_NE(error_of(bytes).find("not a number"), std::string::npos);
  bytes = good;
  const float smaller = 1.0f;
  std::memcpy(bytes.data() + bytes.size() - 5, &smaller, 4);
  EXPECT_NE(error_of(bytes).find("maximum of its children"), std::string::npos);
}

/// Changed bytes are refused or give a map, never a crash; most are refused.
TEST(VoxelFiles, SurvivesMutants) {
  RandomStream random(9, "mutants");
  for (const VoxelFormat format : {VoxelFormat::kOt, VoxelFormat::kBt}) {
    const std::string good = voxel_map_bytes(random_map(3, "blocks"), format);
    int accepted = 0;
    constexpr int kMutants = 400;
    for (int i = 0; i < kMutants; ++i) {
      std::string bytes = good;
      for (std::uint64_t n = 1 + random.below(4); n > 0; --n)
        bytes[random.below(bytes.size())] ^= static_cast<char>(1 + random.below(255));
      if (random.below(4) == 0) bytes.resize(random.below(bytes.size()));
      if (error_of(bytes).empty()) ++accepted;
    }
    EXPECT_LT(accepted, format == VoxelFormat::kOt ? kMutants / 3 : kMutants / 2);
  }
}

TEST(VoxelFiles, ReadsOctoMapsOwnMap) {
  const std::filesystem::path file = test_data() / "octomap" / "geb079.bt";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const VoxelMap map = load_voxel_map(file);
  EXPECT_DOUBLE_EQ(map.resolution_m(), 0.08);
  EXPECT_EQ(map.counts(), (VoxelCounts{950759, 185673}));
  const VoxelMap again = parse_voxel_map(voxel_map_bytes(map, VoxelFormat::kBt), "again");
  EXPECT_TRUE(same_values(map, again));
}

// rgbd_slambook5: five depth images with poses and the OctoMap that plain OctoMap makes of them.

std::vector<std::uint16_t> read_depth(const std::filesystem::path& file, int& width, int& height) {
  std::ifstream in(file, std::ios::binary);
  std::string magic;
  int max = 0;
  in >> magic;
  while ((in >> std::ws).peek() == '#') std::getline(in, magic);
  in >> width >> height >> max;
  in.get();
  std::vector<std::uint16_t> depth(static_cast<std::size_t>(width * height));
  for (std::uint16_t& d : depth) {
    const int high = in.get(), low = in.get();
    d = static_cast<std::uint16_t>(high << 8 | low);
  }
  return depth;
}

Cloud<Map> cloud_of(const std::vector<std::uint16_t>& depth, int width, const Transform<Map, Camera>& T_map_camera) {
  Cloud<Map> cloud;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (depth[i] == 0 || depth[i] >= 7000) continue;
    const double u = static_cast<double>(i % static_cast<std::size_t>(width));
    const double v = static_cast<double>(i / static_cast<std::size_t>(width));
    const double z = depth[i] / 1000.0;
    const Eigen::Vector3d p((u - 325.5) * z / 518.0, (v - 253.5) * z / 519.0, z);
    cloud.points.push_back((T_map_camera * Point<Camera>{p}).p.cast<float>());
  }
  return cloud;
}

void expect_nearly_equal(const VoxelMap& a, const VoxelMap& b) {
  std::size_t both = 0;
  const std::vector<Voxel> occupied = a.voxels(Occupancy::kOccupied);
  for (const Voxel& o : occupied) both += b.at(o) == Occupancy::kOccupied ? 1u : 0u;
  const double either = static_cast<double>(occupied.size() + b.counts().occupied - both);
  EXPECT_GT(static_cast<double>(both) / either, 0.995);
  EXPECT_NEAR(static_cast<double>(a.counts().free), static_cast<double>(b.counts().free),
              0.01 * static_cast<double>(a.counts().free));
}

TEST(VoxelFiles, RebuildsTheMapOfTheSlambook) {
  const std::filesystem::path folder = test_data() / "rgbd_slambook5";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  VoxelMapParams params;
  params.store = "octomap";
  VoxelMap map(params), fast;
  std::ifstream poses(folder / "pose.txt");
  for (int i = 1; i <= 5; ++i) {
    double v[7];
    for (double& value : v) poses >> value;
    Transform<Map, Camera> T;
    T.T = Eigen::Isometry3d(Eigen::Quaterniond(v[6], v[3], v[4], v[5]));
    T.T.pretranslate(Eigen::Vector3d(v[0], v[1], v[2]));
    int width = 0, height = 0;
    const auto depth = read_depth(folder / "depth" / (std::to_string(i) + ".pgm"), width, height);
    const Cloud<Map> cloud = cloud_of(depth, width, T);
    map.insert(cloud, {T.position()});
    if (i > 1) continue;
    fast.insert(cloud, {T.position()});
    expect_nearly_equal(map, fast);
  }
  EXPECT_EQ(map.counts(), (VoxelCounts{308458, 44846}));
  EXPECT_TRUE(voxel_map_bytes(map, VoxelFormat::kBt) == load_bytes(folder / "reference_octomap.bt"));
}

}  // namespace
}  // namespace amiss::mapping
