#include "page/events.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base64.hpp"

namespace amiss::page {
namespace {

using nlohmann::json;

const Stamp kNow{duration_of(12.3456789)};

RC_GTEST_PROP(Events, VoxelsTakeEightCharactersEach, (const std::vector<std::array<std::int16_t, 3>>& indices)) {
  std::vector<mapping::Voxel> voxels;
  std::string one_by_one;
  for (const auto& v : indices) {
    voxels.push_back({v[0], v[1], v[2]});
    const auto text = voxels_text(std::vector<mapping::Voxel>{voxels.back()});
    RC_ASSERT(text.size() == 8U);
    one_by_one += text;
  }
  RC_ASSERT(voxels_text(voxels) == one_by_one);
}

TEST(Events, VoxelsAreLittleEndian) {
  EXPECT_EQ(voxels_text(std::vector<mapping::Voxel>{{1, -2, 259}}), base64(std::string("\x01\x00\xfe\xff\x03\x01", 6)));
}

TEST(Events, LinesAreOneLineOfJson) {
  mission::StepEvent step;
  step.pose.stamp = kNow;
  step.pose.T_map_base = {1.23456, -2.0, 0.123456};
  const json pose = json::parse(pose_line(step, {0.0, 0.0, 0.0}));
  EXPECT_EQ(pose["e"], "pose");
  EXPECT_EQ(pose["t"], 12.346);
  EXPECT_EQ(pose["p"], json({1.235, -2.0, 0.1235}));

  const std::string log = log_line(kNow, "two\nlines, \"quoted\" \xff <script>");
  EXPECT_EQ(log.find('\n'), std::string::npos);
  EXPECT_EQ(script_line({kNow, "add mug"}),
            R"({"e":"script","t":)" + json::parse(log)["t"].dump() + R"(,"text":"add mug"})");
  EXPECT_EQ(json::parse(log)["text"], "two\nlines, \"quoted\" \xef\xbf\xbd <script>");
}

TEST(Events, PlansNameTheirPlaces) {
  const std::vector<mission::PlannedStep> steps{
      {mission::PlannedStep::Action::kGoto, {mission::Visit::Kind::kExamine, 3, {1.0, 2.0, 0.5}}},
      {mission::PlannedStep::Action::kExamine, {mission::Visit::Kind::kExamine, 3, {1.0, 2.0, 0.5}}}};
  const json plan = json::parse(plan_line({kNow, 2, "", "", &steps}));
  EXPECT_EQ(plan["number"], 2);
  EXPECT_EQ(plan["steps"][0], json({{"action", "goto"}, {"of", "region"}, {"id", 3}, {"p", {1.0, 2.0, 0.5}}}));
  EXPECT_EQ(plan["steps"][1]["action"], "examine");
}

/// Two rotations about the axes that a page is told must do what the robot's kinematics do.
TEST(Events, HeadTurnsAboutItsAxes) {
  const robot::Model model = robot::load_model(std::filesystem::path(AMISS_SOURCE_DIR) / "robot_model" / "hsr.urdf");
  const FloorGrid floor;
  const mapping::VoxelMap map;
  const json robot = json::parse(start_line({"0", "w", "dynamic", 1, &floor, &map, &model, 0.1, 0.5, 0.5}))["robot"];
  const auto vector = [](const json& v) { return Eigen::Vector3d(v[0], v[1], v[2]); };
  const auto about = [&](const json& axis, double angle) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.translate(vector(axis["p"]));
    T.rotate(Eigen::AngleAxisd(angle, vector(axis["axis"])));
    T.translate(-vector(axis["p"]));
    return T;
  };
  const json& c = robot["camera"];
  Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();
  camera.translate(vector(c));
  camera.rotate(Eigen::Quaterniond(c[6], c[3], c[4], c[5]).normalized());
  for (const double pan : {0.0, 1.2, -2.0}) {
    for (const double tilt : {0.0, -0.7, 0.3}) {
      const Eigen::Isometry3d shown = about(robot["pan"], pan) * about(robot["tilt"], tilt) * camera;
      EXPECT_TRUE(shown.isApprox(model.T_base_camera({pan, tilt}).T, 2e-3)) << pan << " " << tilt;
    }
  }
  int shapes = 0;
  for (const json& link : robot["links"]) shapes += static_cast<int>(link["shapes"].size());
  EXPECT_GT(shapes, 20);
}

TEST(Events, FloorIsPackedFourCellsInAByte) {
  FloorGrid floor(0.05, {1.0, 2.0}, 5, 1);
  for (const int x : {0, 4}) floor.set({x, 0}, Occupancy::kOccupied);
  floor.set({1, 0}, Occupancy::kFree);
  const mapping::VoxelMap map;
  const robot::Model model = robot::load_model(std::filesystem::path(AMISS_SOURCE_DIR) / "robot_model" / "hsr.urdf");
  const json start = json::parse(start_line({"0", "w", "static", 1, &floor, &map, &model, 0.1, 0.5, 0.5}));
  EXPECT_EQ(start["floor"]["cells"], base64(std::string("\x06\x02", 2)));
  EXPECT_EQ(start["floor"]["width"], 5);
}

}  // namespace
}  // namespace amiss::page
