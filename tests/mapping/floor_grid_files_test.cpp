#include "mapping/floor_grid_files.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "core/files.hpp"
#include "core/result.hpp"
#include "mapping/test_data.hpp"

namespace amiss::mapping {
namespace {

const std::string kYaml =
    "image: m.pgm\nresolution: 0.05\norigin: [-1.5, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string header_error(const std::string& yaml) {
  try {
    (void)parse_floor_grid_header(yaml, "m.yaml");
  } catch (const InputError& e) {
    return e.what();
  }
  return {};
}

std::string image_error(const std::string& pgm) {
  try {
    (void)parse_floor_grid(parse_floor_grid_header(kYaml, "m.yaml"), pgm, "m.pgm");
  } catch (const InputError& e) {
    return e.what();
  }
  return {};
}

RC_GTEST_PROP(FloorGridFiles, WhatIsSavedIsLoaded, ()) {
  const TestFolder folder;
  const int width = *rc::gen::inRange(1, 20), height = *rc::gen::inRange(1, 20);
  FloorGrid grid(*rc::gen::element(0.05, 0.1, 1.0 / 3.0), {-1.25, 7.0 / 3.0}, width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) grid.set({x, y}, static_cast<Occupancy>(*rc::gen::inRange(0, 3)));
  }
  save_floor_grid(folder / "map.yaml", grid);
  RC_ASSERT(load_floor_grid(folder / "map.yaml") == grid);
}

TEST(FloorGridFiles, ReadsTextAndBinaryImagesTopRowFirst) {
  const FloorGridHeader header = parse_floor_grid_header(kYaml, "m.yaml");
  const FloorGrid text = parse_floor_grid(header, "P2 # made by hand\n# two rows\n2 2\n255\n0 254\n205 254\n", "m.pgm");
  const FloorGrid binary = parse_floor_grid(header, "P5\n2 2\n255\n" + std::string("\x00\xfe\xcd\xfe", 4), "m.pgm");
  EXPECT_EQ(text, binary);
  EXPECT_EQ(text.at(Cell{0, 1}), Occupancy::kOccupied);
  EXPECT_EQ(text.at(Cell{1, 1}), Occupancy::kFree);
  EXPECT_EQ(text.at(Cell{0, 0}), Occupancy::kUnknown);
  EXPECT_DOUBLE_EQ(text.origin_m().x(), -1.5);
  EXPECT_EQ(text.at(Eigen::Vector2d(-1.49, 2.06)), Occupancy::kOccupied);
}

TEST(FloorGridFiles, NegateTurnsDarkAndLight) {
  const FloorGridHeader header = parse_floor_grid_header(replaced(kYaml, "negate: 0", "negate: 1"), "m.yaml");
  const FloorGrid grid = parse_floor_grid(header, "P2 2 1 100 0 100", "m.pgm");
  EXPECT_EQ(grid.at(Cell{0, 0}), Occupancy::kFree);
  EXPECT_EQ(grid.at(Cell{1, 0}), Occupancy::kOccupied);
}

TEST(FloorGridFiles, SaysWhatIsWrongInTheHeader) {
  EXPECT_EQ(header_error(kYaml), "");
  EXPECT_NE(header_error("").find("YAML map"), std::string::npos);
  EXPECT_NE(header_error("image: [").find("m.yaml:"), std::string::npos);
  EXPECT_NE(header_error(replaced(kYaml, "image: m.pgm", "")).find("image is missing"), std::string::npos);
  EXPECT_NE(header_error(replaced(kYaml, "0.05", ".nan")).find("finite"), std::string::npos);
  EXPECT_NE(header_error(replaced(kYaml, "0.05", "0")).find("0.001 to 10"), std::string::npos);
  EXPECT_NE(header_error(replaced(kYaml, "2, 0]", "2, 0.5]")).find("yaw must be 0"), std::string::npos);
  EXPECT_NE(header_error(replaced(kYaml, "2, 0]", "2]")).find("[x, y, yaw]"), std::string::npos);
  EXPECT_NE(header_error(replaced(kYaml, "0.65", "0.1")).find("free <= occupied"), std::string::npos);
  EXPECT_NE(header_error(kYaml + "mode: raw\n").find("trinary"), std::string::npos);
}

TEST(FloorGridFiles, SaysWhatIsWrongInTheImage) {
  EXPECT_EQ(image_error("P2 1 1 255 0"), "");
  EXPECT_NE(image_error("").find("not a PGM"), std::string::npos);
  EXPECT_NE(image_error("P6 1 1 255 0").find("P2 and P5"), std::string::npos);
  EXPECT_NE(image_error("P5 0 1 255 0").find("the width"), std::string::npos);
  EXPECT_NE(image_error("P5 1 99999999999 255 0").find("the height"), std::string::npos);
  EXPECT_NE(image_error("P5 32768 32768 255 0").find("more than"), std::string::npos);
  EXPECT_NE(image_error("P5 1 1 65535 0").find("largest grey"), std::string::npos);
  EXPECT_NE(image_error("P5 2 2 255 abc").find("cut short"), std::string::npos);
  EXPECT_NE(image_error("P2 2 2 255 1 2 3    x").find("a pixel"), std::string::npos);
}

TEST(FloorGridFiles, LoadsTheArenaOfTheWorldRobotSummit) {
  const std::filesystem::path file = test_data() / "worlds" / "toyota_wrs2020" / "maps" / "map.yaml";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const FloorGrid grid = load_floor_grid(file);
  EXPECT_DOUBLE_EQ(grid.resolution_m(), 0.05);
  EXPECT_EQ(grid.origin_m(), Eigen::Vector2d(-5, -5));
  for (const Occupancy value : {Occupancy::kFree, Occupancy::kOccupied, Occupancy::kUnknown}) {
    EXPECT_GT(std::count(grid.cells().begin(), grid.cells().end(), value), 100);
  }
}

TEST(FloorGridFiles, AMissingImageIsNamed) {
  const TestFolder folder;
  save_atomically(folder / "map.yaml", replaced(kYaml, "m.pgm", "gone.pgm"));
  try {
    (void)load_floor_grid(folder / "map.yaml");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("gone.pgm"), std::string::npos);
  }
}

}  // namespace
}  // namespace amiss::mapping
