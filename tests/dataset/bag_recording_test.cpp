// Bags with messages as ROS writes them, and bags that nobody should have written.
#include <gtest/gtest.h>

#include <cmath>

#include "core/files.hpp"
#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "dataset/bag_writer.hpp"
#include "dataset/recording.hpp"

namespace amiss::dataset {
namespace {

constexpr const char* kColour = "/hsrb/head_rgbd_sensor/rgb/image_rect_color";
constexpr const char* kDepth = "/hsrb/head_rgbd_sensor/depth_registered/image_rect_raw";
constexpr const char* kFrame = "head_rgbd_sensor_rgb_frame";
constexpr std::uint32_t kWidth = 8, kHeight = 6;

test::BagImage image(double stamp_s, const std::string& encoding, std::uint32_t bytes_a_pixel) {
  test::BagImage made{stamp_s, kFrame, encoding, kWidth, kHeight, kWidth * bytes_a_pixel + 4, {}};  // rows may be padded
  for (std::uint32_t i = 0; i < made.step * kHeight; ++i) made.data.push_back(static_cast<std::uint8_t>(i));
  return made;
}

struct BagOptions {
  std::string compression = "none", colour = "rgb8", depth = "16UC1", parent = "map";
};

/// Three frames at 100.0, 100.1, 100.2 s; the robot drives 1 m/s along x of the map, the camera is turned by 90 degrees.
std::string bag_bytes(const BagOptions& options) {
  test::BagWriter bag(options.compression);
  bag.write("/tf_static", test::BagTransform{99.0, "base", std::string("/") + kFrame, 0.5, M_PI_2});
  for (int i = 0; i < 5; ++i) {
    bag.write("/tf", test::BagTransform{99.95 + 0.1 * i, options.parent, "base", 0.1 * i, 0.0});
  }
  bag.write("/hsrb/head_rgbd_sensor/depth_registered/camera_info",
            test::BagCamera{kWidth, kHeight, 99.0, 10.0, 11.0, 3.5, 2.5});
  for (int i = 0; i < 3; ++i) {
    const double t = 100.0 + 0.1 * i;
    bag.write(kColour, image(t + 0.005, options.colour, options.colour == "mono8" ? 1 : 3));
    bag.write(kDepth, image(t, options.depth, options.depth == "32FC1" ? 4 : 2));
  }
  return bag.bytes();
}

struct BagRecordingTest : testing::Test {
  test::TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "run.bag";

  void write_bag(const BagOptions& options = {}) const { save_atomically(file, bag_bytes(options)); }
  [[nodiscard]] std::string why(const RecordingOptions& options = {}) const {
    try {
      static_cast<void>(open_recording(file, options));
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  }
};

TEST_F(BagRecordingTest, ReadsWhatRosWroteInEachCompression) {
  for (const char* compression : {"none", "bz2", "lz4"}) {
    write_bag({.compression = compression});
    const auto recording = open_recording(file);
    EXPECT_EQ(recording->format(), "ROS 1 bag");
    ASSERT_EQ(recording->size(), 3U);
    EXPECT_EQ(recording->dropped(), 0U);
    const PosedFrame second = recording->load(1);
    EXPECT_EQ(second.frame.intrinsics, (CameraIntrinsics{8, 6, 10, 11, 3.5, 2.5}));
    EXPECT_NEAR(seconds(second.frame.stamp), 100.1, 1e-9);
    EXPECT_TRUE(second.frame.colour[9] == (Rgb{31, 32, 33})) << "row 1 begins at byte 28, its second pixel at 31";
    EXPECT_FLOAT_EQ(second.frame.depth_m[9], static_cast<float>(0x1716) / 1000.0F);
    EXPECT_NEAR(second.T_map_camera.position().x(), 0.15 + 0.5, 1e-6) << "between two transforms, and the fixed one";
    EXPECT_TRUE((second.T_map_camera.T.linear() * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY(), 1e-9));
  }
}

TEST_F(BagRecordingTest, OtherEncodingsAndOptions) {
  write_bag({.colour = "bgr8", .depth = "32FC1"});
  EXPECT_TRUE(open_recording(file)->load(0).frame.colour[0] == (Rgb{2, 1, 0}));
  write_bag({.colour = "mono8", .depth = "mono16"});
  RecordingOptions given;
  given.intrinsics = CameraIntrinsics{0, 0, 5, 5, 1, 1};
  given.depth_scale = 100.0;
  const auto recording = open_recording(file, given);
  EXPECT_TRUE(recording->load(0).frame.colour[3] == (Rgb{3, 3, 3}));
  EXPECT_EQ(recording->load(0).frame.intrinsics, (CameraIntrinsics{8, 6, 5, 5, 1, 1}));
  EXPECT_FLOAT_EQ(recording->load(0).frame.depth_m[1], static_cast<float>(0x0302) / 100.0F);
}

TEST_F(BagRecordingTest, SaysWhatIsMissing) {
  write_bag({.compression = "zip"});
  EXPECT_NE(why().find("is compressed by 'zip'; none, bz2 and lz4 are allowed"), std::string::npos) << why();
  write_bag();
  RecordingOptions other_topic, other_frame;
  other_topic.depth_topic = "/depth";
  other_frame.map_frame = "world";
  EXPECT_NE(why(other_topic).find("has no topic '/depth' of depth"), std::string::npos);
  EXPECT_NE(why(other_frame).find("/tf does not say where the frame 'head_rgbd_sensor_rgb_frame' is in 'world'"),
            std::string::npos);
  write_bag({.colour = "yuv422"});
  EXPECT_EQ(why(), "nothing") << "only a frame that is loaded is decoded";
  EXPECT_THROW(static_cast<void>(open_recording(file)->load(0)), InputError);
  write_bag({.parent = "odom"});
  EXPECT_NE(why().find("is in 'map'"), std::string::npos);
}

/// Each byte of a small bag broken, and the bag cut at each place: a sentence or a recording, never more.
TEST_F(BagRecordingTest, BrokenBagsEndWithASentence) {
  for (const char* compression : {"none", "bz2", "lz4"}) {
    write_bag({.compression = compression});
    const std::string whole = load_bytes(file);
    std::size_t refused = 0;
    for (std::size_t at = 13; at < whole.size(); at += 101) {
      std::string broken = whole;
      broken[at] = static_cast<char>(broken[at] ^ (1 << (at % 8)));
      for (const std::string& bytes : {broken, whole.substr(0, at)}) {
        save_atomically(file, bytes);
        try {
          const auto recording = open_recording(file);
          for (std::size_t i = 0; i < recording->size(); ++i) static_cast<void>(recording->load(i));
        } catch (const InputError&) {
          ++refused;
        }
      }
    }
    EXPECT_GT(refused, 10U);
  }
}

}  // namespace
}  // namespace amiss::dataset
