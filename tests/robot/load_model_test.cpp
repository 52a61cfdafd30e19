#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/result.hpp"
#include "robot/model.hpp"

namespace amiss::robot {
namespace {

namespace fs = std::filesystem;

class LoadModelTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("amiss_urdf_" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path write(const std::string& text, const std::string& name = "r.urdf") const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  void expect_refused(const std::string& text, const std::string& part, const std::string& name = "r.urdf") const {
    const fs::path file = write(text, name);
    ::testing::internal::CaptureStderr();
    try {
      (void)load_model(file);
      ADD_FAILURE() << "accepted: " << text.substr(0, 80);
    } catch (const InputError& error) {
      const std::string sentence = error.what();
      EXPECT_EQ(sentence.rfind(file.string(), 0), 0U) << sentence;
      EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
      EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  }
  fs::path folder_;
};

std::string joint(const std::string& name, const std::string& type, const std::string& parent, const std::string& child,
                  const std::string& more = "") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child + "'/>" +
         more + "</joint>";
}

const std::string kLimit = "<axis xyz='0 0 1'/><limit lower='-1' upper='1' velocity='2' effort='1'/>";

/// The least robot that is accepted, with `more` in it.
std::string least(const std::string& more = "", const std::string& camera = "head_rgbd_sensor_rgb_frame") {
  return "<robot name='r'><link name='base_link'/><link name='pan'/><link name='tilt'/><link name='" + camera +
         "'/><link name='base_range_sensor_link'/>" + joint("head_pan_joint", "revolute", "base_link", "pan", kLimit) +
         joint("head_tilt_joint", "revolute", "pan", "tilt", kLimit) + joint("c", "fixed", "tilt", camera) +
         joint("l", "fixed", "base_link", "base_range_sensor_link", "<origin xyz='0.1 0.2 0.3'/>") + more + "</robot>";
}

TEST_F(LoadModelTest, AcceptsTheLeastRobot) {
  const Model model = load_model(write(least()));
  EXPECT_EQ(model.name, "r");
  EXPECT_EQ(model.links.size(), 5U);
  EXPECT_EQ(model.joints.size(), 4U);
  EXPECT_TRUE(model.warnings.empty());
  EXPECT_DOUBLE_EQ(model.limits.tilt_max_rad, 1.0);
  EXPECT_LT((model.T_base_laser.position() - Eigen::Vector3d(0.1, 0.2, 0.3)).norm(), 1e-12);
}

TEST_F(LoadModelTest, TurnsABodyFrameIntoAnOpticalOne) {
  const Model model = load_model(write(least("", "head_rgbd_sensor_link")));
  const Eigen::Matrix3d R = model.T_base_camera({0.0, 0.0}).T.linear();
  EXPECT_LT((R.col(2) - Eigen::Vector3d::UnitX()).norm(), 1e-9);
  EXPECT_LT((R.col(1) + Eigen::Vector3d::UnitZ()).norm(), 1e-9);
}

TEST_F(LoadModelTest, SurvivesOddJointsUnknownElementsAndMissingMeshes) {
  const Model model = load_model(write(
      least("<gazebo reference='base_link'><material>Gazebo/White</material></gazebo><transmission name='t'/>"
            "<link name='a'><visual><geometry><mesh filename='package://nowhere/a.stl'/></geometry></visual></link>"
            "<link name='b'><collision><geometry><sphere radius='-1'/></geometry></collision></link><link name='f'/>" +
            joint("wheel", "continuous", "base_link", "a", "<axis xyz='0 2 0'/><limit effort='1' velocity='1'/>") +
            joint("follower", "revolute", "base_link", "b", kLimit + "<mimic joint='head_pan_joint'/>") +
            joint("free", "floating", "base_link", "f"))));
  EXPECT_EQ(model.warnings.size(), 3U);
  const auto by_name = [&](const std::string& name) {
    return *std::find_if(model.joints.begin(), model.joints.end(), [&](const Joint& j) { return j.name == name; });
  };
  EXPECT_EQ(by_name("wheel").kind, Joint::Kind::kRevolute);
  EXPECT_TRUE(std::isinf(by_name("wheel").upper));
  EXPECT_LT((by_name("wheel").axis - Eigen::Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_DOUBLE_EQ(by_name("follower").mimic_multiplier, 1.0);
  EXPECT_EQ(by_name("free").kind, Joint::Kind::kFixed);
  const auto poses = model.link_poses({{"head_pan_joint", 0.5}});
  const Eigen::AngleAxisd turned(poses[by_name("follower").child].linear());
  EXPECT_NEAR(turned.angle(), 0.5, 1e-9);
}

TEST_F(LoadModelTest, FindsMeshesOfItsPackage) {
  write("solid x\nendsolid x\n", "my_robot/meshes/a.stl");
  const std::string mesh =
      "<link name='a'><visual><geometry><mesh filename='package://my_robot/meshes/a.stl' scale='1 2 3'/>"
      "</geometry></visual></link>" +
      joint("j", "fixed", "base_link", "a");
  const Model model = load_model(write(least(mesh), "my_robot/urdf/r.urdf"));
  EXPECT_TRUE(model.warnings.empty());
  std::size_t found = 0;
  for (const Link& link : model.links) {
    for (const LinkShape& shape : link.visuals) {
      EXPECT_EQ(shape.kind, LinkShape::Kind::kMesh);
      EXPECT_TRUE(fs::exists(shape.mesh));
      EXPECT_EQ(shape.dimensions, Eigen::Vector3d(1, 2, 3));
      ++found;
    }
  }
  EXPECT_EQ(found, 1U);
}

TEST_F(LoadModelTest, SaysWhatIsMissing) {
  const std::string whole = least();
  const auto without = [&](const std::string& name, const std::string& other) {
    std::string text = whole;
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1))
      text.replace(at, name.size(), other);
    return text;
  };
  expect_refused(without("head_pan_joint", "neck"), "head_pan_joint");
  expect_refused(without("head_tilt_joint", "nod"), "head_tilt_joint");
  expect_refused(without("head_rgbd_sensor_rgb_frame", "eye"), "camera frame");
  expect_refused(without("base_range_sensor_link", "feeler"), "laser frame");
}

TEST_F(LoadModelTest, RefusesBrokenFilesWithOneSentence) {
  std::string deep = "<robot name='r'>";
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  expect_refused("", "empty");
  expect_refused(std::string(500, '\0'), "zero bytes");
  expect_refused("\x80\x91<<>>garbage", "no <robot>");
  expect_refused(least().substr(0, 200), "not a URDF");
  expect_refused(deep, "nest deeper");
  expect_refused("<robot xmlns:xacro='x'><xacro:include filename='a'/></robot>", "xacro");
  expect_refused("<robot name='r'/>", "not a URDF");
  expect_refused(
      least("<link name='a'/><link name='b'/>" + joint("x", "fixed", "a", "b") + joint("y", "fixed", "b", "a")), "");
  expect_refused("<robot name='r'><link name='a'/><link name='b'/>" + joint("x", "fixed", "a", "b") +
                     joint("y", "fixed", "b", "a") + "</robot>",
                 "not a URDF");
  expect_refused(least("<link name='a'/>" + joint("x", "fixed", "base_link", "a") + joint("y", "fixed", "pan", "a")),
                 "");
  EXPECT_THROW((void)load_model(folder_ / "absent.urdf"), InputError);
}

TEST_F(LoadModelTest, SurvivesEveryCutOfOurOwnModel) {
  std::ifstream in(AMISS_SOURCE_DIR "/robot_model/hsr.urdf");
  std::stringstream text;
  text << in.rdbuf();
  const std::string whole = text.str();
  for (std::size_t length = 0; length + 12 < whole.size(); length += 97) {
    EXPECT_THROW((void)load_model(write(whole.substr(0, length))), InputError) << length;
  }
}

TEST_F(LoadModelTest, PublicModelsOfTheHsrLoad) {
  const char* given = std::getenv("AMISS_TEST_DATA");
  const fs::path data = given != nullptr ? fs::path(given) : fs::path(AMISS_SOURCE_DIR) / ".." / "shared" / "data";
  if (!fs::exists(data / "robots")) GTEST_SKIP() << "no robots of others in " << data;
  std::size_t loaded = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(data / "robots")) {
    if (entry.path().extension() == ".xacro") {
      EXPECT_THROW((void)load_model(entry.path()), InputError);
    }
    if (entry.path().extension() != ".urdf") continue;
    const Model model = load_model(entry.path());
    EXPECT_GT(model.links.size(), 40U);
    EXPECT_LT((model.T_base_camera({0.0, -0.5}).position() - Eigen::Vector3d(0.053, 0.022, 0.979)).norm(), 1e-3);
    ++loaded;
  }
  EXPECT_EQ(loaded, 3U);
}

}  // namespace
}  // namespace amiss::robot
