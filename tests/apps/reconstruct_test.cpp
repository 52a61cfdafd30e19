// amiss reconstruct on tiny recordings: its files, that threads do not change them, layouts of others, broken ones.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "dataset/cloud_files.hpp"
#include "dataset/trajectory_files.hpp"
#include "dataset/tum_writer.hpp"
#include "mapping/surface_scene.hpp"
#include "mapping/test_data.hpp"
#include "mapping/voxel_files.hpp"
#include "program.hpp"

namespace amiss {
namespace {

namespace fs = std::filesystem;
using test::Ended;

constexpr std::size_t kFrames = 4;

/// A corner with furniture, a quarter of the pixels: 4 cm voxels are to it what 1 cm is to a real one.
void write_recording(const fs::path& folder, double pose_error_m = 0.0) {
  mapping::SurfaceRecording r = mapping::surface_recording(static_cast<int>(kFrames), true, mapping::small_camera());
  dataset::TumWriter writer(folder, {mapping::small_camera(), 5000.0});
  for (std::size_t i = 0; i < kFrames; ++i) {
    r.frames[i].stamp = Stamp(std::chrono::milliseconds(100 * (i + 1)));
    if (i > 0) r.poses[i].T.translation().x() += pose_error_m;
    writer.add({r.frames[i], r.poses[i]});
  }
  writer.finish();
}

struct Reconstruct : testing::Test {
  test::TemporaryFolder folder;

  [[nodiscard]] Ended reconstruct(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"reconstruct", "--voxel", "0.04"});
    return test::run(arguments, folder.path());
  }
  [[nodiscard]] nlohmann::json report(const std::string& out) const {
    return nlohmann::json::parse(folder.read(out + "/report.json"));
  }
  void expect_refusal(int status, const std::vector<std::string>& arguments,
                      const std::vector<std::string>& words) const {
    const Ended ended = reconstruct(arguments);
    SCOPED_TRACE(ended.err);
    EXPECT_EQ(ended.status, status);
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1);
    for (const std::string& word : words) EXPECT_NE(ended.err.find(word), std::string::npos) << "without " << word;
  }
};

TEST_F(Reconstruct, GivesPointsTrianglesAndSpace) {
  write_recording(folder.path() / "scene1");
  const Ended ended = reconstruct({"scene1", "--out", "out"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  EXPECT_NE(ended.out.find("4 frames (TUM RGB-D folder)"), std::string::npos) << ended.out;
  const fs::path out = folder.path() / "out";

  const dataset::CloudFile ply = dataset::load_cloud(out / "cloud.ply"), pcd = dataset::load_cloud(out / "cloud.pcd");
  ASSERT_GT(ply.cloud().points.size(), 1000U);
  EXPECT_TRUE(ply.cloud().points == pcd.cloud().points);
  EXPECT_TRUE(ply.cloud().colours == pcd.cloud().colours);
  EXPECT_TRUE(ply.cloud().normals == pcd.cloud().normals);
  const mapping::TestScene scene = mapping::surface_scene();
  const auto far = std::count_if(ply.cloud().points.begin(), ply.cloud().points.end(), [&](const Eigen::Vector3f& p) {
    return std::abs(mapping::distance_to(scene, p.cast<double>())) > 0.04;
  });
  EXPECT_LT(static_cast<double>(far), 0.02 * static_cast<double>(ply.cloud().points.size()));

  const Ended shown = test::run({"scene", "out", "--out", "room.3Dscene"}, folder.path());
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_EQ(folder.read("room.3Dscene").substr(0, 2), "\x1f\x8b");
  EXPECT_EQ(test::run({"scene", "out", "--out", "room.3Dscene", "--at", "1"}, folder.path()).status, 2);

  const dataset::CloudFile mesh = dataset::load_cloud(out / "mesh.ply");
  const mapping::VoxelMap space = mapping::load_voxel_map(out / "space.bt");
  EXPECT_EQ(space.at(Eigen::Vector3d(0.7, 0.0, 0.5)), Occupancy::kFree);
  EXPECT_EQ(dataset::parse_tum_trajectory(folder.read("out/trajectory.txt"), "trajectory").size(), kFrames);
  EXPECT_EQ(folder.read("out/status"), "finished\n");
  EXPECT_NE(folder.read("out/params.yaml").find("voxel: 0.04"), std::string::npos);
  const nlohmann::json json = report("out");
  EXPECT_EQ(json["frames"], kFrames);
  EXPECT_EQ(json["points"], ply.cloud().points.size());
  EXPECT_EQ(json["triangles"], mesh.mesh.triangles.size());
  EXPECT_EQ(json["space"]["free"], space.counts().free);
  EXPECT_GT(json["wall"]["frames_per_s"], 10.0) << "faster than real time";
}

TEST_F(Reconstruct, ThreadsDoNotChangeTheFiles) {
  write_recording(folder.path() / "scene1", 0.01);
  ASSERT_EQ(reconstruct({"scene1", "--out", "one", "--refine", "--set", "refine.pixel_step=2"}).status, 0);
  ASSERT_EQ(
      reconstruct({"scene1", "--out", "two", "--refine", "--set", "refine.pixel_step=2", "--threads", "2"}).status, 0);
  for (const char* file : {"cloud.ply", "cloud.pcd", "mesh.ply", "space.bt", "trajectory.txt", "params.yaml"}) {
    const std::string one = folder.read("one/" + std::string(file));
    EXPECT_FALSE(one.empty()) << file;
    EXPECT_TRUE(one == folder.read("two/" + std::string(file))) << file;
  }
}

TEST_F(Reconstruct, RefinesPoses) {
  write_recording(folder.path() / "scene1", 0.015);
  ASSERT_EQ(
      reconstruct({"scene1", "--out", "out", "--refine", "--set", "refine.pixel_step=2", "--set", "surface.voxel=0.02"})
          .status,
      0);
  EXPECT_EQ(report("out")["refinement"]["accepted"], kFrames - 1);
  const auto exact = mapping::surface_recording(static_cast<int>(kFrames), false, mapping::small_camera()).poses;
  const auto used = dataset::parse_tum_trajectory(folder.read("out/trajectory.txt"), "trajectory");
  ASSERT_EQ(used.size(), kFrames);
  for (std::size_t i = 0; i < kFrames; ++i) {
    EXPECT_LT((used[i].T_map_camera.position() - exact[i].position()).norm(), 0.008) << i;
  }
}

TEST_F(Reconstruct, OfVoxels) {
  write_recording(folder.path() / "scene1");
  const Ended ended = reconstruct({"scene1", "--out", "out", "--method", "octomap", "--every", "2"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(report("out")["frames"], 2);
  EXPECT_FALSE(fs::exists(folder.path() / "out" / "mesh.ply"));
  EXPECT_GT(dataset::load_cloud(folder.path() / "out" / "cloud.ply").cloud().points.size(), 500U);
}

/// The same images in the layouts of 7-Scenes and of Open3D give the same room.
TEST_F(Reconstruct, ReadsTheLayoutsOfOthers) {
  write_recording(folder.path() / "tum");
  const fs::path scenes = folder.path() / "scenes", open3d = folder.path() / "open3d";
  for (const fs::path& made : {scenes, open3d / "color", open3d / "depth"}) fs::create_directories(made);
  const auto poses = mapping::surface_recording(static_cast<int>(kFrames), false, mapping::small_camera()).poses;
  std::ofstream log(open3d / "trajectory.log");
  log.precision(17);
  for (std::size_t i = 0; i < kFrames; ++i) {
    char stamp[32], name[32];
    (void)std::snprintf(stamp, sizeof stamp, "0.%zu00000000.png", i + 1);
    (void)std::snprintf(name, sizeof name, "frame-%06zu", i);
    const fs::path colour = folder.path() / "tum" / "rgb" / stamp, depth = folder.path() / "tum" / "depth" / stamp;
    fs::copy(colour, scenes / (std::string(name) + ".color.png"));
    fs::copy(depth, scenes / (std::string(name) + ".depth.png"));
    fs::copy(colour, open3d / "color" / stamp);
    fs::copy(depth, open3d / "depth" / stamp);
    std::ofstream pose(scenes / (std::string(name) + ".pose.txt"));
    pose.precision(17);
    pose << poses[i].T.matrix() << '\n';
    log << i << ' ' << i << ' ' << i + 1 << '\n' << poses[i].T.matrix() << '\n';
  }
  log.close();
  fs::copy(folder.path() / "tum" / "camera.yaml", open3d / "camera.yaml");
  ASSERT_EQ(reconstruct({"tum", "--out", "a"}).status, 0);
  const CameraIntrinsics k = mapping::small_camera();
  char camera[160];
  (void)std::snprintf(camera, sizeof camera, "%.17g,%.17g,%.17g,%.17g", k.fx, k.fy, k.cx, k.cy);
  const Ended b = reconstruct({"scenes", "--out", "b", "--intrinsics", camera, "--depth-scale", "5000"});
  const Ended c = reconstruct({"open3d", "--out", "c"});
  ASSERT_EQ(b.status, 0) << b.err;
  ASSERT_EQ(c.status, 0) << c.err;
  EXPECT_EQ(report("b")["format"], "7-Scenes folder");
  EXPECT_EQ(report("c")["format"], "Open3D folder");
  const double points = report("a")["points"];
  EXPECT_NEAR(report("b")["points"], points, 0.01 * points);
  EXPECT_NEAR(report("c")["points"], points, 0.01 * points);
}

/// A real kitchen by a camera in the hand (Microsoft's 7-Scenes): its table is flat and 0.699 m high.
TEST_F(Reconstruct, ARealKitchen) {
  const fs::path kitchen = mapping::test_data() / "rgbd_redkitchen" / "reference";
  if (!fs::exists(kitchen)) GTEST_SKIP() << "no " << kitchen;
  const Ended ended = test::run({"reconstruct", kitchen.string(), "--out", "out", "--voxel", "0.02", "--refine",
                                 "--set", "refine.planar=false", "--intrinsics", "585,585,320,240"},
                                folder.path());
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(report("out")["frames"], 84);
  EXPECT_GT(report("out")["refinement"]["accepted"], 75);
  const Cloud<Map> cloud = dataset::load_cloud(folder.path() / "out" / "cloud.ply").cloud();
  std::size_t near = 0, on_table = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const float z = cloud.points[i].z();
    if (z < 0.64F || z > 0.76F || cloud.normals[i].z() < 0.9F) continue;
    ++near;
    on_table += std::abs(z - 0.699F) < 0.02F ? 1U : 0U;
  }
  EXPECT_GT(on_table, 1500U) << "0.6 square metres at least";
  EXPECT_GT(static_cast<double>(on_table), 0.7 * static_cast<double>(near)) << "and things on it";
}

TEST_F(Reconstruct, RefusesBrokenRecordings) {
  expect_refusal(3, {"none", "--out", "out"}, {"none"});
  fs::create_directory(folder.path() / "empty");
  expect_refusal(3, {"empty", "--out", "out"}, {"empty", "is no recording that is known"});
  write_recording(folder.path() / "scene1");
  const std::string camera = folder.read("scene1/camera.yaml");
  fs::remove(folder.path() / "scene1" / "camera.yaml");
  expect_refusal(3, {"scene1", "--out", "out"}, {"camera.yaml", "--intrinsics"});
  (void)folder.write("scene1/camera.yaml", camera);
  const std::string poses = folder.read("scene1/groundtruth.txt");
  (void)folder.write("scene1/groundtruth.txt", poses + "0.9 1 2 nan 0 0 0 1\n");
  expect_refusal(3, {"scene1", "--out", "out"}, {"groundtruth.txt"});
  EXPECT_FALSE(fs::exists(folder.path() / "out")) << "nothing was begun";
  (void)folder.write("scene1/groundtruth.txt", poses);
  (void)folder.write("scene1/depth/0.300000000.png", "no image");
  expect_refusal(3, {"scene1", "--out", "out"}, {"0.300000000.png"});
  EXPECT_EQ(folder.read("out/status"), "running\n") << "never half a reconstruction that looks whole";
  EXPECT_FALSE(fs::exists(folder.path() / "out" / "report.json"));
}

TEST_F(Reconstruct, RefusesWrongArguments) {
  write_recording(folder.path() / "scene1");
  expect_refusal(2, {"scene1", "--method", "voxblox"}, {"voxblox", "tsdf", "octomap"});
  expect_refusal(2, {"scene1", "--voxel", "0"}, {"--voxel"});
  expect_refusal(2, {"scene1", "--set", "surface.voxle=0.1"}, {"did you mean 'surface.voxel'?"});
  expect_refusal(2, {"scene1", "--set", "reconstruct.space=3"}, {"reconstruct.space", "1, 2, 4"});
  expect_refusal(2, {"scene1", "--set", "surface.max_range=0.5", "--set", "surface.min_range=0.9"}, {"min_range"});
  expect_refusal(2, {"scene1", "--method", "octomap", "--refine"}, {"tsdf only"});
  expect_refusal(2, {"scene1", "--intrinsics", "1,2"}, {"--intrinsics"});
  expect_refusal(2, {"scene1", "--every", "0"}, {"--every"});
  (void)folder.write("scene1/file", "x");
  expect_refusal(2, {"scene1", "--out", "scene1"}, {"scene1"});
}

}  // namespace
}  // namespace amiss
