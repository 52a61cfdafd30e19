// `amiss replay` of a ROS 1 bag: a run's own recording, said once more in an HSR's topics, gives the run's regions.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "apps/program.hpp"
#include "core/files.hpp"
#include "dataset/bag_writer.hpp"
#include "recording/recording.hpp"

namespace amiss {
namespace {

using test::Ended;

constexpr const char *kBase = "base_footprint", *kLaser = "base_range_sensor_link",
                     *kCamera = "head_rgbd_sensor_rgb_frame";
constexpr const char* kRgbd = "/hsrb/head_rgbd_sensor/";

test::BagPose posed(Stamp stamp, const char* parent, const char* child, const Eigen::Isometry3d& T) {
  const Eigen::Quaterniond q(T.linear());
  const Eigen::Vector3d p = T.translation();
  return {seconds(stamp), parent, child, p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
}

/// The pictures of a recording by their stamps, as they were before JPEG but for what it took away.
using Pictures = std::map<Stamp, cv::Mat>;
Pictures pictures_of(const std::filesystem::path& file) {
  Pictures pictures;
  recording::McapReader reader(file);
  while (const auto message = reader.next()) {
    if (message->channel->topic != "/camera/rgb/image_raw/compressed") continue;
    const std::string_view jpeg = message->data.substr(message->data.find("\xff\xd8\xff"));
    pictures[message->stamp] = cv::imdecode(std::vector<unsigned char>(jpeg.begin(), jpeg.end()), cv::IMREAD_COLOR);
  }
  return pictures;
}

struct BagOptions {
  std::string depth_encoding = "16UC1";
  bool scans = true, camera_frames = true, odometry = true;
  int most_periods = 1'000'000;
};

class HsrBag {
 public:
  HsrBag(const std::filesystem::path& recording, const Pictures& pictures, const BagOptions& options)
      : options_(options), pictures_(pictures), bag_("lz4") {
    recording::Recording recorded(recording);
    bag_.write("/tf_static", posed({}, kBase, kLaser, recorded.setup().T_base_laser.T));
    int periods = 0;
    while (const auto entry = recorded.next()) {
      const auto* said = std::get_if<robot::Observation>(&*entry);
      if (said == nullptr) continue;
      if (++periods > options.most_periods) break;
      if (said->scan && options.scans) add(*said->scan);
      if (said->frame) add(*said->frame);
      const auto odometry = posed(said->odometry.stamp, "odom", kBase, said->odometry.T_odom_base.lift().T);
      options.odometry ? bag_.write_odometry("/hsrb/odom", odometry) : bag_.write("/tf", odometry);
    }
  }
  [[nodiscard]] const std::string& bytes() const { return bag_.bytes(); }

 private:
  void add(const LaserScan& s) {
    bag_.write("/hsrb/base_scan", test::BagScan{seconds(s.stamp), kLaser, s.angle_min_rad, s.angle_step_rad,
                                                s.min_range_m, s.max_range_m, s.ranges_m});
  }
  void add(const robot::CapturedFrame& captured) {
    const RgbdFrame& frame = captured.frame;
    const CameraIntrinsics& c = frame.intrinsics;
    const double stamp_s = seconds(frame.stamp);
    const auto width = static_cast<std::uint32_t>(c.width), height = static_cast<std::uint32_t>(c.height);
    if (options_.camera_frames) bag_.write("/tf", posed(frame.stamp, kBase, kCamera, captured.T_base_camera.T));
    bag_.write(std::string(kRgbd) + "depth_registered/camera_info",
               test::BagCamera{width, height, c.fx, c.fx, c.fy, c.cx, c.cy});
    const cv::Mat& picture = pictures_.at(frame.stamp);
    bag_.write(
        std::string(kRgbd) + "rgb/image_rect_color",
        test::BagImage{stamp_s, kCamera, "bgr8", width, height, width * 3, {picture.datastart, picture.dataend}});
    const bool is_metric = options_.depth_encoding == "32FC1";
    test::BagImage depth{stamp_s, kCamera, options_.depth_encoding, width, height, width * (is_metric ? 4 : 2), {}};
    const auto append = [&](auto value) {
      const auto* bytes = reinterpret_cast<const std::uint8_t*>(&value);
      depth.data.insert(depth.data.end(), bytes, bytes + sizeof value);
    };
    for (const float d : frame.depth_m) {
      is_metric ? append(d) : append(static_cast<std::uint16_t>(std::isnan(d) ? 0 : std::lround(d * 1000.0F)));
    }
    bag_.write(std::string(kRgbd) + "depth_registered/image_rect_raw", depth);
  }

  BagOptions options_;
  const Pictures& pictures_;
  test::BagWriter bag_;
};

/// One run for all tests: its recording, its reference as a folder, what its replay says.
struct ReplayBag : testing::Test {
  static inline std::unique_ptr<test::TemporaryFolder> folder;
  static inline nlohmann::json of_run;
  static inline Pictures pictures;

  static void SetUpTestSuite() {
    folder = std::make_unique<test::TemporaryFolder>();
    const Ended run = test::run({"tidy", "--world", AMISS_SOURCE_DIR "/tests/scenarios/worlds/two_rooms.sdf",
                                 "--objects", "2", "--seed", "3", "--record", "mcap", "--out", "run", "--quiet"},
                                folder->path());
    ASSERT_EQ(run.status, 0) << run.err;
    recording::Recording recorded(mcap());
    std::filesystem::create_directory(folder->path() / "reference");
    for (const auto& [name, bytes] : recorded.documents()) save_atomically(folder->path() / "reference" / name, bytes);
    pictures = pictures_of(mcap());
    of_run = nlohmann::json::parse(replay({"run/recording.mcap"}).out);
  }
  static void TearDownTestSuite() { folder.reset(); }

  static std::filesystem::path mcap() { return folder->path() / "run" / "recording.mcap"; }
  static Ended replay(std::vector<std::string> words) {
    words.insert(words.begin(), {"replay", "--json"});
    return test::run(words, folder->path());
  }
  static Ended replay_bag(const BagOptions& options, const std::vector<std::string>& more = {}) {
    folder->write("a.bag", HsrBag(mcap(), pictures, options).bytes());
    std::vector<std::string> words{"a.bag", "--reference", "reference"};
    words.insert(words.end(), more.begin(), more.end());
    return replay(words);
  }
};

void expect_regions_of_the_run(const nlohmann::json& found, const nlohmann::json& of_run) {
  const auto &regions = found.at("regions"), &wanted = of_run.at("regions");
  ASSERT_EQ(regions.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_NEAR(regions[i].at("centre")[0], wanted[i].at("centre")[0], 0.05);
    EXPECT_NEAR(regions[i].at("centre")[1], wanted[i].at("centre")[1], 0.05);
    EXPECT_NEAR(regions[i].at("radius_m"), wanted[i].at("radius_m"), 0.05);
    EXPECT_EQ(regions[i].at("withdrawn"), wanted[i].at("withdrawn"));
  }
}

TEST_F(ReplayBag, DepthInMillimetresGivesTheRegionsOfTheRun) {
  const Ended replayed = replay_bag({});
  ASSERT_EQ(replayed.status, 0) << replayed.err;
  const auto found = nlohmann::json::parse(replayed.out);
  expect_regions_of_the_run(found, of_run);
  EXPECT_EQ(found.at("frames"), of_run.at("frames"));
  EXPECT_EQ(found.at("dropped"), 0);
  EXPECT_EQ(found.at("objects").size(), of_run.at("objects").size()) << "segmented where a frame showed the region";
}

TEST_F(ReplayBag, SoDoDepthInMetresAndOdometryFromTransforms) {
  const Ended replayed = replay_bag({.depth_encoding = "32FC1", .odometry = false}, {"--start", "0,0,0"});
  ASSERT_EQ(replayed.status, 0) << replayed.err;
  expect_regions_of_the_run(nlohmann::json::parse(replayed.out), of_run);
  const Ended elsewhere = replay({"a.bag", "--reference", "reference", "--start=1,0.5,40"});
  ASSERT_EQ(elsewhere.status, 0) << elsewhere.err;
  expect_regions_of_the_run(nlohmann::json::parse(elsewhere.out), of_run);  // it finds itself
}

TEST_F(ReplayBag, SaysWhatIsMissing) {
  const auto expect_refused = [](const Ended& ended, const std::string& why) {
    EXPECT_EQ(ended.status, 3) << ended.out;
    EXPECT_NE(ended.err.find("a.bag: " + why), std::string::npos) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << "one sentence: " << ended.err;
  };
  expect_refused(replay_bag({.scans = false, .most_periods = 60}),
                 "has no topic '/hsrb/base_scan' of sensor_msgs/LaserScan; there is none of that type");
  expect_refused(replay_bag({.camera_frames = false, .most_periods = 60}),
                 "/tf and /tf_static do not say where the frame 'head_rgbd_sensor_rgb_frame' is in 'base_footprint'");
  expect_refused(replay_bag({.most_periods = 60}, {"--depth-topic", "/depth"}),
                 "has no topic '/depth' of sensor_msgs/Image (16UC1, mono16, 32FC1); there are: /hsrb/");
  expect_refused(replay_bag({.most_periods = 60}, {"--colour-topic", "/rgb"}),
                 "has no topic '/rgb' of sensor_msgs/Image");
  for (const auto& [option, value] : {std::pair{"--start", "0,0,0"}, {"--scan-topic", "/scan"}}) {
    EXPECT_NE(replay({"run/recording.mcap", option, value}).err.find(option + std::string(" is for bags")),
              std::string::npos);
  }
  expect_refused(replay({"a.bag"}), "holds no reference; --reference DIR names a folder of `amiss map`");
  const std::string whole = folder->read("a.bag");
  folder->write("a.bag", std::string_view(whole).substr(0, whole.size() / 2));
  expect_refused(replay({"a.bag", "--reference", "reference"}), "ends in the middle of a record");
}

}  // namespace
}  // namespace amiss
