// The layouts of folders that others use, and what is refused.
#include "dataset/recording.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "dataset/tum_writer.hpp"
#include "mapping/test_data.hpp"

namespace amiss::dataset {
namespace {

namespace fs = std::filesystem;

constexpr CameraIntrinsics kCamera{4, 3, 10, 10, 1.5, 1};

/// A folder of one frame for each time, in the layout that TumWriter writes.
void write_tum(const fs::path& folder, std::initializer_list<int> milliseconds) {
  TumWriter writer(folder, {kCamera, 5000.0});
  for (const int ms : milliseconds) {
    PosedFrame posed;
    posed.frame = {Stamp(std::chrono::milliseconds(ms)), kCamera, std::vector<Rgb>(12), std::vector<float>(12, 1.0F)};
    posed.T_map_camera.T.translate(Eigen::Vector3d(0.01 * ms, 0, 0));
    writer.add(posed);
  }
  writer.finish();
}

std::string why(const fs::path& path, const RecordingOptions& options = {}) {
  try {
    const auto recording = open_recording(path, options);
    for (std::size_t i = 0; i < recording->size(); ++i) (void)recording->load(i);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(Recording, TumTimesNeedNotMeetExactly) {
  const test::TemporaryFolder folder;
  write_tum(folder.path() / "run", {0, 100, 200, 300});
  // Colour comes 15 ms earlier, once 30 ms; poses at other times than images, a gap, CR LF, comments.
  folder.write("run/rgb.txt",
               "#c\r\n0.085 rgb/0.100000000.png\r\n0.185 rgb/0.200000000.png\n0.27 rgb/0.300000000.png\n");
  folder.write("run/groundtruth.txt", "0.05 0 0 0 0 0 0 1\n0.15 1 0 0 0 0 0 1\n# x\n0.25 2 0 0 0 0 0 1\n");
  const auto recording = open_recording(folder.path() / "run");
  ASSERT_EQ(recording->size(), 2U);
  EXPECT_EQ(recording->dropped(), 1U);
  EXPECT_NEAR(recording->load(0).T_map_camera.position().x(), 0.5, 1e-9);
  EXPECT_NEAR(recording->load(1).T_map_camera.position().x(), 1.5, 1e-9);
}

TEST(Recording, AssociationsAndOptionsOverrule) {
  const test::TemporaryFolder folder;
  write_tum(folder.path() / "run", {100, 200});
  fs::remove(folder.path() / "run/camera.yaml");
  fs::remove(folder.path() / "run/rgb.txt");
  folder.write("run/associations.txt", "0.1 rgb/0.100000000.png 0.1 depth/0.200000000.png\n");
  EXPECT_NE(why(folder.path() / "run").find("camera.yaml"), std::string::npos);
  RecordingOptions options{CameraIntrinsics{0, 0, 5, 6, 1, 2}, 2500.0};
  const auto recording = open_recording(folder.path() / "run", options);
  const PosedFrame frame = recording->load(0);
  EXPECT_EQ(frame.frame.intrinsics, (CameraIntrinsics{4, 3, 5, 6, 1, 2}));
  EXPECT_FLOAT_EQ(frame.frame.depth_m[0], 2.0F);
}

TEST(Recording, SaysWhatIsWrong) {
  const test::TemporaryFolder folder;
  EXPECT_NE(why(folder.path() / "nowhere").find("there is no such file or folder"), std::string::npos);
  EXPECT_NE(why(folder.path()).find("is no recording that is known"), std::string::npos);
  write_tum(folder.path() / "run", {100});
  folder.write("run/depth/0.100000000.png", "no image");
  EXPECT_NE(why(folder.path() / "run").find("depth/0.100000000.png: is no image"), std::string::npos);
  fs::copy_file(folder.path() / "run/rgb/0.100000000.png", folder.path() / "run/depth/0.100000000.png",
                fs::copy_options::overwrite_existing);
  EXPECT_NE(why(folder.path() / "run").find("one channel of 16 bits"), std::string::npos);
  folder.write("run/rgb.txt", "0.1\n");
  EXPECT_NE(why(folder.path() / "run").find("rgb.txt:1: a line must be 'time file'"), std::string::npos);
  folder.write("run/rgb.txt", "7 rgb/0.100000000.png\n");
  EXPECT_NE(why(folder.path() / "run").find("has no frame with colour, depth and a pose"), std::string::npos);
  folder.write("run/associations.txt", "0.1 rgb/0.100000000.png 0.1 depth/0.100000000.png\n");
  folder.write("run/depth.txt", "0.1\n");
  EXPECT_NE(why(folder.path() / "run").find("depth.txt:1: a line must be 'time file'"), std::string::npos);
  RecordingOptions elsewhere;
  elsewhere.poses = "poses.txt";
  EXPECT_THROW(static_cast<void>(open_recording(folder.path(), elsewhere)), ArgumentError);
}

TEST(Recording, ADamagedPictureIsToldOfOnce) {
  const test::TemporaryFolder folder;
  write_tum(folder.path() / "run", {100});
  const std::string whole = folder.read("run/depth/0.100000000.png");
  testing::internal::CaptureStderr();
  for (std::size_t size = 1; size < whole.size(); ++size) {
    folder.write("run/depth/0.100000000.png", whole.substr(0, size));
    EXPECT_NE(why(folder.path() / "run").find("depth/0.100000000.png: is no image"), std::string::npos) << size;
  }
  std::string damaged = whole;
  damaged[damaged.size() / 2] = static_cast<char>(~damaged[damaged.size() / 2]);
  folder.write("run/depth/0.100000000.png", damaged);
  EXPECT_NE(why(folder.path() / "run").find("depth/0.100000000.png: is no image"), std::string::npos);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "libpng has nothing to add";
}

TEST(Recording, FoldersOfOthers) {
  const fs::path data = mapping::test_data();
  if (!fs::exists(data / "rgbd_open3d")) GTEST_SKIP() << "no data of others in " << data;
  const RecordingOptions scenes{CameraIntrinsics{0, 0, 585, 585, 320, 240}, std::nullopt};
  const auto kitchen = open_recording(data / "rgbd_redkitchen" / "reference", scenes);
  EXPECT_EQ(kitchen->format(), "7-Scenes folder");
  EXPECT_EQ(kitchen->size(), 84U);
  EXPECT_NEAR(kitchen->load(0).T_map_camera.position().z(), 1.324433604, 1e-9);
  const RecordingOptions kinect{CameraIntrinsics{0, 0, 525, 525, 319.5, 239.5}, std::nullopt};
  const auto room = open_recording(data / "rgbd_open3d" / "livingroom1_clean_micro", kinect);
  EXPECT_EQ(room->format(), "Open3D folder");
  EXPECT_GE(room->size(), 40U);
  EXPECT_EQ(open_recording(data / "rgbd_open3d" / "RGBD", kinect)->load(4).frame.depth_m.size(), 307200U);
}

}  // namespace
}  // namespace amiss::dataset
