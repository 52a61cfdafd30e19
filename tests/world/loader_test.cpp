#include "world/loader.hpp"

#include <algorithm>

#include "core/result.hpp"
#include "files_for_test.hpp"
#include "world/bounds.hpp"

namespace amiss::world {
namespace {

using LoaderTest = FilesForTest;

const Body& body_named(const World& world, const std::string& name) {
  const auto found =
      std::find_if(world.bodies.begin(), world.bodies.end(), [&](const Body& body) { return body.name == name; });
  if (found == world.bodies.end()) throw std::runtime_error("no body " + name);
  return *found;
}

bool any_contains(const std::vector<std::string>& sentences, const std::string& part) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& sentence) { return sentence.find(part) != std::string::npos; });
}

void expect_at(const Body& body, const Eigen::Vector3d& p) {
  EXPECT_LT((body.pose.position() - p).norm(), 1e-9) << body.name << " at " << body.pose.position().transpose();
}

TEST_F(LoaderTest, ReadsEveryPrimitiveWithItsSize) {
  const World world = load_world(write("w.sdf", world_text(R"(<model name='m'><static>1</static><link name='l'>
      <visual name='1'><geometry><box><size>1 2 3</size></box></geometry></visual>
      <visual name='2'><geometry><cylinder><radius>0.5</radius><length>2</length></cylinder></geometry></visual>
      <visual name='3'><geometry><sphere><radius>0.25</radius></sphere></geometry></visual>
      <visual name='4'><geometry><plane><normal>0 0 1</normal><size>4 5</size></plane></geometry></visual>
      <visual name='5'><geometry><capsule><radius>0.1</radius><length>1</length></capsule></geometry></visual>
      <visual name='6'><geometry><ellipsoid><radii>0.1 0.2 0.3</radii></ellipsoid></geometry></visual>
      <visual name='7'><geometry><sphere><radius>-1</radius></sphere></geometry></visual>
      </link></model>)")));
  ASSERT_EQ(world.bodies.size(), 1U);
  const std::vector<Shape>& shapes = world.bodies[0].visuals;
  ASSERT_EQ(shapes.size(), 6U);
  const std::vector<Eigen::Vector3d> sizes = {{1, 2, 3}, {1, 1, 2},       {0.5, 0.5, 0.5},
                                              {4, 5, 0}, {0.2, 0.2, 1.2}, {0.2, 0.4, 0.6}};
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const Eigen::Vector3d size = bounds(shapes[i].geometry, Eigen::Isometry3d::Identity()).sizes();
    EXPECT_LT((size - sizes[i]).norm(), 1e-6) << i << ": " << size.transpose();
  }
  EXPECT_TRUE(any_contains(world.warnings, "geometry is left out"));
}

TEST_F(LoaderTest, ComposesPosesOfModelLinkAndShape) {
  const World world = load_world(write("w.sdf", world_text(R"(<model name='m'><pose>1 2 0 0 0 1.5707963267948966</pose>
      <link name='l'><pose>1 0 0.5 0 0 0</pose>
      <collision name='c'><pose>0 0.25 0 0 0 0</pose><geometry><sphere><radius>0.1</radius></sphere></geometry></collision>
      </link></model>)")));
  const Body& body = body_named(world, "m");
  EXPECT_FALSE(body.is_static);
  expect_at(body, {1, 3, 0.5});
  ASSERT_EQ(body.collisions.size(), 1U);
  EXPECT_LT((body.pose.T * body.collisions[0].T_body_shape.translation() - Eigen::Vector3d(0.75, 3, 0.5)).norm(), 1e-9);
}

TEST_F(LoaderTest, ResolvesPosesRelativeToFramesModelsLinksAndJoints) {
  write("models/table/model.sdf", as_file("<model name='table'><link name='leg'/><link name='top'><pose>0 0 0.8 0 0 0"
                                          "</pose></link></model>"));
  const World world = load_world(write(
      "w.sdf", world_text("<frame name='room'><pose>10 0 0 0 0 1.5707963267948966</pose></frame>"
                          "<frame name='robot_start'><pose relative_to='room'>1 0 0 0 0 0</pose></frame>" +
                              box_model("a", "1 1 1", "<pose relative_to='room'>1 0 0 0 0 0</pose>") +
                              box_model("b", "1 1 1", "<pose relative_to='a'>0 0 1 0 0 0</pose>") +
                              "<include><uri>model://table</uri><pose relative_to='room'>2 0 0 0 0 0</pose></include>" +
                              box_model("c", "1 1 1", "<pose relative_to='table::top'>0 0 0.1 0 0 0</pose>"),
                          "1.8")));
  expect_at(body_named(world, "a"), {10, 1, 0});
  expect_at(body_named(world, "b"), {10, 1, 1});
  expect_at(body_named(world, "c"), {10, 2, 0.9});
  ASSERT_TRUE(world.robot_start);
  EXPECT_NEAR(world.robot_start->x_m, 10, 1e-9);
  EXPECT_NEAR(world.robot_start->y_m, 1, 1e-9);
  EXPECT_NEAR(world.robot_start->yaw_rad, 1.5707963, 1e-6);
}

TEST_F(LoaderTest, TakesRawNumbersWhereAFrameIsMissing) {
  const World world =
      load_world(write("w.sdf", world_text(box_model("a", "1 1 1", "<pose relative_to='nowhere'>1 2 3 0 0 0</pose>") +
                                           box_model("b", "1 1 1", "<pose>4 5 6 0 0 0</pose>"))));
  expect_at(body_named(world, "a"), {1, 2, 3});
  expect_at(body_named(world, "b"), {4, 5, 6});
  EXPECT_TRUE(any_contains(world.warnings, "nowhere"));
}

TEST_F(LoaderTest, FindsIncludesByEveryKindOfUri) {
  write("models/near/model.sdf", as_file(box_model("near", "1 1 1")));
  write("lib/far/model.config",
        "<model><name>far</name><sdf version='1.4'>old.sdf</sdf><sdf version='1.7'>new.sdf</sdf></model>");
  write("lib/far/old.sdf", as_file(box_model("far", "9 9 9")));
  write("lib/far/new.sdf", as_file(box_model("far", "2 2 2")));
  const auto sdf = write(
      "sub/w.sdf",
      world_text(
          "<include><uri>model://near</uri></include>"
          "<include><name>second</name><uri>../models/near</uri><pose>3 0 0 0 0 0</pose><static>true</static></include>"
          "<include><name>third</name><uri>file://" +
          (folder_ / "models/near/model.sdf").string() +
          "</uri></include>"
          "<include><name>fourth</name><uri>package://near/model.sdf</uri></include>"
          "<include><uri>model://far</uri></include>"
          "<include><uri>model://absent</uri></include>"
          "<include><uri>model://../../etc</uri></include>"));
  const World world = load_world(sdf, {{folder_ / "lib"}, 512});
  EXPECT_EQ(world.bodies.size(), 5U);
  EXPECT_FALSE(body_named(world, "near").is_static);
  EXPECT_TRUE(body_named(world, "second").is_static);
  expect_at(body_named(world, "second"), {3, 0, 0});
  EXPECT_LT((bounds_in_world(body_named(world, "far")).sizes() - Eigen::Vector3d(2, 2, 2)).norm(), 1e-9);
  EXPECT_TRUE(any_contains(world.warnings, "w.sdf:4: model 'model://absent' is not found"));
}

TEST_F(LoaderTest, PutsNestedModelsAndIncludesIntoOneStaticBody) {
  write("models/leg/model.sdf",
        as_file(
            "<model name='leg'><pose>0 0 7 0 0 0</pose><link name='l'><pose>0 0 0.1 0 0 0</pose>"
            "<collision name='c'><geometry><box><size>0.1 0.1 0.2</size></box></geometry></collision></link></model>"));
  const World world = load_world(
      write("w.sdf", world_text("<model name='desk'><static>true</static><pose>5 0 0 0 0 0</pose>"
                                "<include><name>leg1</name><uri>model://leg</uri><pose>1 0 0 0 0 0</pose></include>"
                                "<include><name>leg2</name><uri>model://leg</uri></include>"
                                "<model name='inner'><pose>0 1 0 0 0 0</pose><link name='l'><pose>0 0 1 0 0 0</pose>"
                                "<collision name='c'><geometry><box><size>1 1 "
                                "0.1</size></box></geometry></collision></link></model></model>")));
  ASSERT_EQ(world.bodies.size(), 1U);
  const Body& desk = world.bodies[0];
  ASSERT_EQ(desk.collisions.size(), 3U);
  std::vector<Eigen::Vector3d> centres;
  for (const Shape& shape : desk.collisions) centres.push_back(desk.pose.T * shape.T_body_shape.translation());
  for (const Eigen::Vector3d& wanted :
       {Eigen::Vector3d(6, 0, 0.1), Eigen::Vector3d(5, 0, 7.1), Eigen::Vector3d(5, 1, 1)}) {
    EXPECT_TRUE(std::any_of(centres.begin(), centres.end(), [&](const auto& c) { return (c - wanted).norm() < 1e-9; }))
        << wanted.transpose();
  }
}

TEST_F(LoaderTest, TiesLinksTogetherByTheirJoints) {
  const std::string link =
      "<link name='%'><pose>0 0 %.5 0 0 0</pose><inertial><mass>2</mass></inertial><collision name='c'>"
      "<geometry><box><size>1 1 1</size></box></geometry></collision></link>";
  const auto numbered = [&](char n) {
    std::string text = link;
    std::replace(text.begin(), text.end(), '%', n);
    return text;
  };
  const World world = load_world(write(
      "w.sdf",
      world_text(
          "<model name='m'>" + numbered('1') + numbered('2') + numbered('3') +
          "<joint name='j' type='revolute'><parent>1</parent><child>2</child><axis><xyz>0 0 1</xyz></axis></joint>"
          "<joint name='k' type='fixed'><parent>world</parent><child>3</child></joint></model>")));
  ASSERT_EQ(world.bodies.size(), 2U);
  EXPECT_EQ(world.bodies[0].name, "m::1");
  EXPECT_DOUBLE_EQ(world.bodies[0].mass_kg, 4.0);
  EXPECT_FALSE(world.bodies[0].is_static);
  EXPECT_EQ(world.bodies[1].name, "m::3");
  EXPECT_TRUE(world.bodies[1].is_static);
  EXPECT_LT((bounds_in_world(world.bodies[0]).max() - Eigen::Vector3d(0.5, 0.5, 3.0)).norm(), 1e-9);
}

TEST_F(LoaderTest, MendsNamesAndMassesWithWarnings) {
  const World world = load_world(write(
      "w.sdf",
      world_text(
          box_model("same", "1 1 1") + box_model("same", "2 2 2") +
          "<model name='bad'><link "
          "name='l'><inertial><mass>-3</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>9</izz></inertia>"
          "</inertial><collision name='c'><geometry><box><size>1 1 1</size></box></geometry></collision></link></model>"
          "<actor name='a'/><plugin name='p' filename='x'/>")));
  EXPECT_EQ(world.bodies.size(), 3U);
  EXPECT_LT((bounds_in_world(body_named(world, "same_2")).sizes() - Eigen::Vector3d(2, 2, 2)).norm(), 1e-9);
  EXPECT_DOUBLE_EQ(body_named(world, "bad").mass_kg, 1.0);
  for (const char* part : {"renamed to 'same_2'", "mass '-3'", "impossible inertia", "<actor>"}) {
    EXPECT_TRUE(any_contains(world.warnings, part)) << part;
  }
}

TEST_F(LoaderTest, ReadsMaterialsFrictionLightsAndScene) {
  const World world = load_world(write("w.sdf", world_text(R"(
      <scene><ambient>0.1 0.2 0.3 1</ambient><background>0.4 0.5 0.6 1</background></scene>
      <light name='s' type='directional'><direction>0 0 -2</direction><diffuse>0.9 0.8 0.7 1</diffuse></light>
      <model name='m'><static>1</static><link name='l'>
      <collision name='c'><geometry><box><size>1 1 1</size></box></geometry>
        <surface><friction><ode><mu>0.3</mu></ode></friction></surface></collision>
      <visual name='1'><geometry><box><size>1 1 1</size></box></geometry>
        <material><diffuse>1 0 0 0.5</diffuse><specular>0.9 0.2 0.2 1</specular></material></visual>
      <visual name='2'><geometry><box><size>1 1 1</size></box></geometry><transparency>0.75</transparency>
        <material><script><uri>file://media/materials/scripts/gazebo.material</uri><name>Gazebo/Blue</name></script></material></visual>
      <visual name='3'><geometry><box><size>1 1 1</size></box></geometry>
        <material><script><uri>file://x</uri><name>Nobody/Knows</name></script></material></visual>
      </link></model>)")));
  const std::vector<Shape>& shapes = world.bodies.at(0).visuals;
  ASSERT_EQ(shapes.size(), 3U);
  EXPECT_EQ(shapes[0].material.diffuse, Eigen::Vector3f(1, 0, 0));
  EXPECT_FLOAT_EQ(shapes[0].material.alpha, 0.5F);
  EXPECT_FLOAT_EQ(shapes[0].material.specular, 0.9F);
  EXPECT_EQ(shapes[1].material.diffuse, Eigen::Vector3f(0, 0, 1));
  EXPECT_FLOAT_EQ(shapes[1].material.alpha, 0.25F);
  EXPECT_TRUE(any_contains(world.warnings, "Nobody/Knows"));
  EXPECT_DOUBLE_EQ(world.bodies[0].friction, 0.3);
  EXPECT_EQ(world.ambient, Eigen::Vector3f(0.1F, 0.2F, 0.3F));
  EXPECT_EQ(world.background, Eigen::Vector3f(0.4F, 0.5F, 0.6F));
  ASSERT_EQ(world.lights.size(), 1U);
  EXPECT_EQ(world.lights[0].direction, Eigen::Vector3f(0, 0, -1));
  EXPECT_EQ(world.lights[0].colour, Eigen::Vector3f(0.9F, 0.8F, 0.7F));
}

TEST_F(LoaderTest, KnowsGroundPlaneAndSunWithoutTheirModels) {
  const World world = load_world(write("w.sdf", world_text("<include><uri>model://sun</uri></include>"
                                                           "<include><uri>model://ground_plane</uri></include>",
                                                           "1.6")));
  EXPECT_EQ(world.bodies.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<Plane>(world.bodies.at(0).collisions.at(0).geometry));
  EXPECT_EQ(world.lights.size(), 1U);
  EXPECT_TRUE(world.warnings.empty()) << world.warnings[0];
}

TEST_F(LoaderTest, LeavesOutModelsThatIncludeThemselves) {
  write("models/a/model.sdf",
        as_file("<model name='a'><include><uri>model://b</uri></include><link name='l'/></model>"));
  write("models/b/model.sdf",
        as_file("<model name='b'><include><uri>model://a</uri></include><link name='l'/></model>"));
  const World world = load_world(write("w.sdf", world_text("<include><uri>model://a</uri></include>")));
  EXPECT_TRUE(any_contains(world.warnings, "includes itself"));
  EXPECT_EQ(world.bodies.size(), 2U);
}

TEST_F(LoaderTest, AppliesTheStateThatASavedWorldKeeps) {
  const World world = load_world(
      write("w.sdf", world_text(box_model("a", "1 1 1", "<pose>1 1 1 0 0 0</pose>") +
                                    "<state world_name='w'><model name='a'><pose>7 8 9 0 0 0</pose></model></state>",
                                "1.6")));
  expect_at(body_named(world, "a"), {7, 8, 9});
}

TEST_F(LoaderTest, RefusesBrokenFilesWithOneSentence) {
  const std::string good = world_text(box_model("a", "1 1 1"));
  std::string deep = "<sdf version='1.7'>";
  for (int i = 0; i < 100000; ++i) deep += "<model name='m'>";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "empty"},
      {" \n ", "empty"},
      {std::string(2000, '\0'), "zero bytes"},
      {good.substr(0, good.size() / 2), "not well-formed XML"},
      {"\x89\x12random\xff\xfe<<>>&&", "not well-formed XML"},
      {"just words", "not well-formed XML"},
      {"<html><body/></html>", "no <sdf> element"},
      {"<sdf version='1.7'></sdf>", "neither a <world> nor a <model>"},
      {as_file(box_model("a", "1 1 1")), "no <world>"},
      {deep, "nest deeper"}};
  for (const auto& [text, part] : cases) {
    const auto file = write("w.sdf", text);
    try {
      (void)load_world(file);
      ADD_FAILURE() << "accepted: " << text.substr(0, 60);
    } catch (const InputError& error) {
      const std::string sentence = error.what();
      EXPECT_EQ(sentence.rfind(file.string(), 0), 0U) << sentence;
      EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
      EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    }
  }
  EXPECT_THROW((void)load_world(folder_ / "absent.sdf"), InputError);
  EXPECT_THROW((void)load_world(folder_), InputError);
}

TEST_F(LoaderTest, SurvivesEveryCutOfAFile) {
  const std::string good = world_text(box_model("a", "1 1 1", "<pose>1 2 3 0 0 0</pose>"));
  for (std::size_t length = 0; length < good.size(); length += 7) {
    const auto file = write("w.sdf", good.substr(0, length));
    EXPECT_THROW((void)load_world(file), InputError) << length;
  }
}

TEST_F(LoaderTest, KeepsQuietAndWritesNothingAtHome) {
  const auto file = write("w.sdf", world_text("<model name='m'><link name='l'><pose>a b</pose></link></model>"));
  ::testing::internal::CaptureStderr();
  try {
    (void)load_world(file);
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("w.sdf"), std::string::npos);
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST_F(LoaderTest, LoadsOneModelFromFileOrFolder) {
  const auto file = write("cup/model.sdf", as_file(box_model("cup", "0.1 0.1 0.2", "<pose>5 5 5 0 0 0</pose>")));
  for (const auto& path : {file, file.parent_path()}) {
    const Body cup = load_model(path);
    EXPECT_EQ(cup.name, "cup");
    EXPECT_FALSE(cup.is_static);
    EXPECT_TRUE(cup.pose.T.matrix().isIdentity());
  }
  EXPECT_THROW((void)load_model(write("w.sdf", world_text(box_model("a", "1 1 1")))), InputError);
  EXPECT_THROW(
      (void)load_model(write("two.sdf", as_file("<model name='m'><link name='a'><collision name='c'><geometry><sphere>"
                                                "<radius>1</radius></sphere></geometry></collision></link><link "
                                                "name='b'><collision name='c'><geometry><sphere>"
                                                "<radius>1</radius></sphere></geometry></collision></link></model>"))),
      InputError);
  EXPECT_THROW((void)load_model(folder_), InputError);
}

TEST_F(LoaderTest, DescribesItsParameters) {
  ParamTable table;
  LoadOptions options;
  describe(table, options);
  table.set_override("world.max_texture=64");
  EXPECT_EQ(options.max_texture_px, 64);
  EXPECT_THROW(table.set_override("world.max_texture=0"), ArgumentError);
}

}  // namespace
}  // namespace amiss::world
