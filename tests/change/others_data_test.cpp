// Novel objects in rooms and on desks that others recorded; skipped where their data is not there.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "change/novel.hpp"
#include "dataset/cloud_files.hpp"
#include "mapping/test_data.hpp"
#include "score/novel_score.hpp"

namespace amiss::change {
namespace {

namespace fs = std::filesystem;

/// A scene with its ground truth; `ignored` points are neither right nor wrong.
struct Annotated {
  Scene scene;
  std::vector<score::PointSet> objects;
  std::vector<bool> ignored;
};

std::vector<score::PointSet> found_in(const Detection& detection, const Annotated& a) {
  std::vector<score::PointSet> found;
  for (const NovelObject& object : detection.objects) {
    score::PointSet points = object.points;
    if (!a.ignored.empty()) std::erase_if(points, [&](std::uint32_t i) { return a.ignored[i]; });
    if (!points.empty()) found.push_back(points);
  }
  return found;
}

void add_objects(Annotated& a, const std::map<int, score::PointSet>& by_number) {
  for (const auto& [number, points] : by_number) a.objects.push_back(points);
}

Annotated house(const std::string& name) {
  constexpr int kFirstObject = 1000;
  const dataset::CloudFile file = dataset::load_cloud(mapping::test_data() / "semantic_house" / name);
  Annotated a;
  a.scene.cloud = file.cloud();
  a.scene.cloud.normals.clear();
  std::map<int, score::PointSet> objects;
  for (std::uint32_t i = 0; i < file.cloud().points.size(); ++i) {
    a.scene.labels.push_back(static_cast<SemanticClass>(file.field("label")->values[i]));
    const auto instance = static_cast<int>(file.field("instance")->values[i]);
    if (instance >= kFirstObject) objects[instance].push_back(i);
  }
  add_objects(a, objects);
  return a;
}

TEST(OthersData, FurnitureOfAHouseMayBeNudgedAndFiveObjectsAreFound) {
  if (!fs::exists(mapping::test_data() / "semantic_house")) GTEST_SKIP() << "semantic_house is not there";
  Annotated reference = house("dining_reference.ply"), current = house("dining_current.ply");
  ASSERT_EQ(current.objects.size(), 5U);
  std::size_t wrong_of_differencing = 0;
  for (const bool labelled : {true, false}) {
    if (!labelled) {
      reference.scene.labels.clear();
      current.scene.labels.clear();
    }
    const NovelDetector detector(reference.scene, current.scene);
    const auto full = score::score_novel(found_in(detector.detect("local-verification"), current), current.objects);
    EXPECT_TRUE(full.missed.empty());
    EXPECT_TRUE(full.wrong.empty());
    EXPECT_GT(full.precision, 0.99);
    EXPECT_GT(full.recall, 0.9);
    const auto metaroom = score::score_novel(found_in(detector.detect("metaroom"), current), current.objects);
    EXPECT_TRUE(metaroom.missed.empty());
    wrong_of_differencing = metaroom.wrong.size();
  }
  EXPECT_GE(wrong_of_differencing, 5U) << "differencing of the whole room takes nudged chairs for novel";
}

Annotated desk(const fs::path& stem, const Eigen::Isometry3d& T_world_camera) {
  constexpr double kF = 525.0, kU = 319.5, kV = 239.5;
  constexpr float kFreeVoxelM = 0.01F;
  const cv::Mat depth = cv::imread(stem.string() + ".depth.png", cv::IMREAD_UNCHANGED);
  const cv::Mat colour = cv::imread(stem.string() + ".color.png", cv::IMREAD_COLOR);
  cv::Mat labels = cv::imread(stem.string() + ".label.png", cv::IMREAD_UNCHANGED);
  labels.convertTo(labels, CV_16U);
  Annotated a;
  RgbdFrame frame;
  frame.intrinsics = {depth.cols, depth.rows, kF, kF, kU, kV};
  std::map<int, score::PointSet> objects;
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      const cv::Vec3b bgr = colour.at<cv::Vec3b>(v, u);
      const double z = 0.001 * depth.at<std::uint16_t>(v, u);
      frame.colour.push_back({bgr[2], bgr[1], bgr[0]});
      frame.depth_m.push_back(z > 0.0 ? static_cast<float>(z) : std::nanf(""));
      if (z <= 0.0) continue;
      const int label = labels.at<std::uint16_t>(v, u);
      const auto i = static_cast<std::uint32_t>(a.scene.cloud.points.size());
      if (label >= 10) objects[label / 10].push_back(i);
      a.ignored.push_back(label == 0);
      a.scene.cloud.points.emplace_back(
          (T_world_camera * Eigen::Vector3d((u - kU) / kF * z, (v - kV) / kF * z, z)).cast<float>());
      a.scene.cloud.colours.push_back(frame.colour.back());
    }
  }
  mapping::VoxelMapParams voxels;
  voxels.resolution_m = static_cast<double>(kFreeVoxelM);
  voxels.max_range_m = 3.0;
  a.scene.space = mapping::VoxelMap(voxels);
  Transform<Map, Camera> pose;
  pose.T = T_world_camera;
  a.scene.space->insert(frame, pose);
  add_objects(a, objects);
  return a;
}

TEST(OthersData, EveryObjectOnADeskIsFoundAgainstTheEmptyDesk) {
  const fs::path top = mapping::test_data() / "rgbd_change_mosd" / "dev";
  if (!fs::exists(top)) GTEST_SKIP() << "rgbd_change_mosd is not there";
  for (const std::string group : {"A", "C"}) {
    const fs::path folder = top / ("group_" + group);
    const auto json = nlohmann::json::parse(std::ifstream(folder / "ground_truth.json"))["group"][group];
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    const auto rows = json["T_world_camera"].get<std::vector<std::vector<double>>>();
    for (Eigen::Index row = 0; row < 3; ++row) {
      for (Eigen::Index column = 0; column < 4; ++column) {
        T.matrix()(row, column) = rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
      }
    }
    const Annotated empty = desk(folder / "empty_reference", T);
    for (const std::string name : json["frames"]) {
      SCOPED_TRACE(name);
      const Annotated now = desk(folder / name, T);
      const auto found = found_in(detect_novel(empty.scene, now.scene, "local-verification"), now);
      const auto score = score::score_novel(found, now.objects);
      EXPECT_TRUE(score.missed.empty());
      EXPECT_TRUE(score.wrong.empty());
      EXPECT_GE(score.recall, 0.88);
      EXPECT_GE(score.precision, 0.998);
    }
  }
}

}  // namespace
}  // namespace amiss::change
