// `amiss dataset` as its users see it: two visits to the smallest room, recorded with hasty looks round.
#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CRawlog.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "apps/program.hpp"
#include "core/files.hpp"
#include "dataset/cloud_files.hpp"
#include "dataset/full_room.hpp"
#include "dataset/recording.hpp"
#include "dataset/trajectory_files.hpp"
#include "world/room_plan.hpp"

namespace amiss {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::Ended;

Ended make(const fs::path& folder, const std::string& out, std::vector<std::string> more) {
  std::vector<std::string> arguments{"dataset",  "make", "--out", out,           "--rooms", "office_desk",
                                     "--visits", "1",    "--set", "tour.pan=10", "--set",   "tour.head_rate=1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return test::run(arguments, folder);
}

/// Contents of all files by their names in the folder.
std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files[fs::relative(entry.path(), folder).string()] = load_bytes(entry.path());
  }
  return files;
}

struct Dataset : testing::Test {
  static void SetUpTestSuite() {
    folder = std::make_unique<test::TemporaryFolder>();
    made = make(folder->path(), "data", {"-j", "2"});
  }
  static void TearDownTestSuite() { folder.reset(); }
  void SetUp() override { ASSERT_EQ(made.status, 0) << made.err; }

  [[nodiscard]] static fs::path scene(const std::string& name) {
    return folder->path() / "data" / "recordings" / "office_desk" / name;
  }
  static std::unique_ptr<test::TemporaryFolder> folder;
  static Ended made;
};
std::unique_ptr<test::TemporaryFolder> Dataset::folder;
Ended Dataset::made;

TEST_F(Dataset, ARecordingHasWhatSensorsSayAndTheTruthApart) {
  EXPECT_NE(made.out.find("2 recordings with 3 objects"), std::string::npos) << made.out;
  const std::string page = folder->read("data/report.html");
  EXPECT_NE(page.find("2 recordings with 3 objects"), std::string::npos);
  EXPECT_NE(page.find("alt=\"office_desk/scene2\" src=\"data:image/jpeg"), std::string::npos) << "its picture";
  const auto recording = dataset::open_recording(scene("scene2"));
  ASSERT_GT(recording->size(), 50U);
  EXPECT_EQ(recording->dropped(), 0U);
  const json report = json::parse(load_bytes(scene("scene2") / "recording.json"));
  EXPECT_EQ(report["frames"], recording->size());
  EXPECT_EQ(report["reached"], report["waypoints"]);
  EXPECT_EQ(report["collisions"], 0);
  // The poses are those that the robot believed in: near the true ones, and not the same.
  const auto truth = dataset::parse_tum_trajectory(load_bytes(scene("scene2") / "groundtruth.txt"), "groundtruth.txt");
  ASSERT_EQ(truth.size(), recording->size());
  double furthest_m = 0.0;
  for (std::size_t i = 0; i < truth.size(); i += 10) {
    const double off_m = (recording->load(i).T_map_camera.position() - truth[i].T_map_camera.position()).norm();
    furthest_m = std::max(furthest_m, off_m);
  }
  EXPECT_GT(furthest_m, 1e-4);
  EXPECT_LT(furthest_m, 0.05);
  EXPECT_GT(load_bytes(scene("scene2") / "laser.log").size(), 10000U);
  EXPECT_FALSE(fs::exists(scene("scene2") / "instances"));
  EXPECT_TRUE(dataset::load_instances(scene("scene1") / "truth" / "instances.tsv").back().kind.empty());
  EXPECT_FALSE(dataset::load_instances(scene("scene2") / "truth" / "instances.tsv").back().kind.empty());
}

TEST_F(Dataset, TheSameSeedGivesTheSameBytesAndWhatIsThereIsNotMadeAgain) {
  const auto before = files_of(folder->path() / "data");
  const auto kept = fs::last_write_time(scene("scene1") / "rgb.txt");
  fs::remove_all(scene("scene2"));
  fs::create_directories(scene(".scene2.making") / "rgb");  // of a run that was killed
  const Ended again = make(folder->path(), "data", {"--quiet"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(again.err + again.out, "");
  EXPECT_EQ(fs::last_write_time(scene("scene1") / "rgb.txt"), kept);
  const auto after = files_of(folder->path() / "data");
  ASSERT_EQ(after.size(), before.size());
  for (const auto& [name, bytes] : before) EXPECT_TRUE(after.contains(name) && after.at(name) == bytes) << name;
}

TEST_F(Dataset, AVisitWithFewerObjectsThanAskedForIsToldOf) {
  const fs::path placed = folder->path() / "data" / "placements" / "office_desk" / "scene2" / "objects.yaml";
  const std::string all = load_bytes(placed);
  save_atomically(placed, all.substr(0, all.rfind("- {")));
  const Ended again = make(folder->path(), "data", {"--quiet"});
  save_atomically(placed, all);
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(again.err, "amiss: office_desk/scene2: 2 of 3 objects found a place\n");
}

/// Of the whole data set as it is made without any options.
TEST(Placements, EveryVisitHasTheObjectsThatItShould) {
  const test::TemporaryFolder folder;
  for (const world::RoomPlan& plan :
       world::load_room_plans(fs::path(AMISS_SOURCE_DIR) / "sim_worlds" / "dataset.yaml")) {
    const std::string job = "place/" + plan.world + "/" + std::to_string(plan.objects.size());
    const Ended ended = test::run({"dataset", "make", "--out", "data", "--child", job}, folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    for (std::size_t k = 0; k < plan.objects.size(); ++k) {
      const std::string scene = plan.world + "/scene" + std::to_string(k + 2);
      const std::string placed = folder.read("data/placements/" + scene + "/objects.yaml");
      EXPECT_EQ(std::count(placed.begin(), placed.end(), '{'), plan.objects[k]) << scene;
    }
  }
}

TEST_F(Dataset, AnotherDataSetIsNotMixedIn) {
  const Ended other = make(folder->path(), "data", {"--seed", "2"});
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("dataset.yaml: made with another seed"), std::string::npos) << other.err;
  const Ended unknown = test::run({"dataset", "make", "--out", "x", "--rooms", "office_desc"}, folder->path());
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("did you mean 'office_desk'?"), std::string::npos) << unknown.err;
  EXPECT_FALSE(fs::exists(folder->path() / "x"));
}

TEST_F(Dataset, MrptReadsTheSameRecording) {
  mrpt::obs::CRawlog log;
  ASSERT_TRUE(log.loadFromRawLogFile((scene("scene2") / "recording.rawlog").string()));
  const auto recording = dataset::open_recording(scene("scene2"));
  const RgbdFrame first = recording->load(0).frame;
  const auto width = static_cast<std::size_t>(first.intrinsics.width);
  std::map<std::string, std::size_t> counts;
  std::size_t same = 0;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const auto observation = log.getAsObservation(i);
    ++counts[observation->sensorLabel];
    if (observation->sensorLabel != "CAMERA") continue;
    const auto& camera = dynamic_cast<const mrpt::obs::CObservation3DRangeScan&>(*observation);
    if (std::abs(mrpt::Clock::toDouble(camera.timestamp) - seconds(first.stamp)) > 1e-6) continue;
    for (std::size_t pixel = 0; pixel < first.depth_m.size(); pixel += 101, ++same) {
      const float theirs_m = 0.001F * static_cast<float>(camera.rangeImage(pixel / width, pixel % width));
      EXPECT_NEAR(std::isnan(first.depth_m[pixel]) ? 0.0F : first.depth_m[pixel], theirs_m, 0.0007F) << pixel;
    }
  }
  EXPECT_GT(same, 1000U) << "the first image of the folder is in the rawlog";
  EXPECT_GE(counts["CAMERA"], recording->size());
  EXPECT_GT(counts["LASER"], counts["CAMERA"]);
  EXPECT_GT(counts["ODOMETRY"], counts["LASER"]);
}

/// A cloud of what a few frames saw is a reconstruction, too.
TEST_F(Dataset, AReconstructionIsAnnotatedInTheLayoutOfFullRooms) {
  const auto recording = dataset::open_recording(scene("scene2"));
  dataset::CloudFile cloud;
  for (std::size_t i = 0; i < recording->size(); i += 5) {
    const dataset::PosedFrame posed = recording->load(i);
    const CameraIntrinsics& camera = posed.frame.intrinsics;
    for (int v = 0; v < camera.height; v += 4) {
      for (int u = 0; u < camera.width; u += 4) {
        const auto pixel = static_cast<std::size_t>(v * camera.width + u);
        const double z_m = static_cast<double>(posed.frame.depth_m[pixel]);
        if (!(z_m < 2.0)) continue;
        const Eigen::Vector3d p((u - camera.cx) / camera.fx * z_m, (v - camera.cy) / camera.fy * z_m, z_m);
        cloud.mesh.vertices.points.emplace_back((posed.T_map_camera.T * p).cast<float>());
      }
    }
  }
  dataset::save_cloud(folder->path() / "made.ply", cloud);
  const Ended ended =
      test::run({"dataset", "annotate", scene("scene2").string(), "made.ply", "--out", "rooms"}, folder->path());
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(ended.out.starts_with("3 of 3 placed objects have points") ||
              ended.out.find(" of 3 placed objects have points; without: ") == 1U)
      << ended.out;
  const fs::path room = folder->path() / "rooms" / "office_desk";
  EXPECT_EQ(dataset::load_cloud(room / "scene2.pcd").cloud().points.size(), cloud.cloud().points.size());
  const fs::path anno = room / "Annotations" / "scene2_GT.anno";
  const auto objects = dataset::parse_annotations(load_bytes(anno), anno.string(), cloud.cloud().points.size());
  ASSERT_FALSE(objects.empty());
  for (const dataset::AnnotatedObject& object : objects) {
    Eigen::AlignedBox3f box;
    for (const std::uint32_t i : object.points) box.extend(cloud.cloud().points[i]);
    EXPECT_LT(box.diagonal().norm(), 0.6F) << object.name;  // not smeared over the room
  }
  const Ended none = test::run({"dataset", "annotate", ".", "made.ply", "--out", "rooms"}, folder->path());
  EXPECT_EQ(none.status, 3);
  for (Eigen::Vector3f& p : cloud.mesh.vertices.points) p.x() += 30.0F;  // of another place
  dataset::save_cloud(folder->path() / "far.ply", cloud);
  const Ended far =
      test::run({"dataset", "annotate", scene("scene2").string(), "far.ply", "--out", "others"}, folder->path());
  EXPECT_EQ(far.status, 3);
  EXPECT_NE(far.err.find("far.ply: 0 of its "), std::string::npos) << far.err;
  EXPECT_FALSE(fs::exists(folder->path() / "others"));
}

/// Points of `some` with a point of `all` no further away than the edge of a voxel.
double part_near(const Cloud<Map>& some, const Cloud<Map>& all, double edge_m) {
  const auto cell_of = [&](const Eigen::Vector3f& p) {
    const Eigen::Vector3d cell = (p.cast<double>() / edge_m).array().floor();
    return std::array{static_cast<int>(cell.x()), static_cast<int>(cell.y()), static_cast<int>(cell.z())};
  };
  std::set<std::array<int, 3>> cells;
  for (const Eigen::Vector3f& p : all.points) {
    const auto [x, y, z] = cell_of(p);
    for (int i = 0; i < 27; ++i) cells.insert({x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1});
  }
  const auto near = std::count_if(some.points.begin(), some.points.end(),
                                  [&](const Eigen::Vector3f& p) { return cells.contains(cell_of(p)); });
  return static_cast<double>(near) / static_cast<double>(some.points.size());
}

TEST_F(Dataset, TheRawlogOfAVisitGivesTheReconstructionOfItsFolder) {
  const auto reconstructed = [&](const fs::path& recording, const std::string& out, std::vector<std::string> more) {
    std::vector<std::string> words{"reconstruct", recording.string(), "--out", out, "--voxel", "0.02"};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = test::run(words, folder->path());
    EXPECT_EQ(ended.status, 0) << ended.err;
    return dataset::load_cloud(folder->path() / out / "cloud.ply").cloud();
  };
  const fs::path rawlog = scene("scene2") / "recording.rawlog";
  const Cloud<Map> of_folder = reconstructed(scene("scene2"), "of_folder", {});
  const Cloud<Map> same_poses =
      reconstructed(rawlog, "same_poses", {"--poses", (scene("scene2") / "estimated.txt").string()});
  EXPECT_GT(part_near(same_poses, of_folder, 0.01), 0.98);
  EXPECT_GT(part_near(of_folder, same_poses, 0.01), 0.98);
  const json report = json::parse(folder->read("same_poses/report.json"));
  EXPECT_EQ(report["format"], "MRPT rawlog");
  EXPECT_EQ(report["frames"], json::parse(folder->read("of_folder/report.json"))["frames"]);
  // Odometry drifts by centimetres, and its floor is that of the wheels.
  const Cloud<Map> own_poses = reconstructed(rawlog, "own_poses", {});
  EXPECT_GT(part_near(own_poses, of_folder, 0.05), 0.95);
  EXPECT_GT(part_near(of_folder, own_poses, 0.05), 0.95);
}

}  // namespace
}  // namespace amiss
