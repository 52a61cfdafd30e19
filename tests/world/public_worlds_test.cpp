// Worlds and objects that others made: they load, with heights and sizes as known.
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "files_for_test.hpp"
#include "world/bounds.hpp"
#include "world/loader.hpp"
#include "world/mesh_file.hpp"

namespace amiss::world {
namespace {

namespace fs = std::filesystem;

class PublicWorldsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(data_ / "worlds")) GTEST_SKIP() << "no worlds of others in " << data_;
  }
  World load(const std::string& file) const {
    return load_world(data_ / "worlds" / file,
                      {{data_ / "ycb/models_light", data_ / "worlds/toyota_wrs2020/models"}, 256});
  }
  fs::path data_ = shared_data();
};

Eigen::AlignedBox3d drawn_bounds(const Body& body) {
  Eigen::AlignedBox3d box;
  for (const Shape& shape : body.visuals) box.extend(bounds(shape.geometry, body.pose.T * shape.T_body_shape));
  return box;
}

const Body& first_containing(const World& world, const std::string& part) {
  const auto found = std::find_if(world.bodies.begin(), world.bodies.end(),
                                  [&](const Body& body) { return body.name.find(part) != std::string::npos; });
  if (found == world.bodies.end()) throw std::runtime_error("no body with " + part);
  return *found;
}

TEST_F(PublicWorldsTest, SmallHouseStandsUprightAtItsHeights) {
  const World world = load("aws_small_house/worlds/small_house.world");
  EXPECT_GT(world.bodies.size(), 80U);
  EXPECT_NEAR(drawn_bounds(first_containing(world, "KitchenTable")).max().z(), 0.801, 0.002);
  EXPECT_NEAR(drawn_bounds(first_containing(world, "CoffeeTable")).max().z(), 0.364, 0.002);
  EXPECT_NEAR(drawn_bounds(first_containing(world, "Refrigerator")).max().z(), 1.95, 0.01);
  std::size_t textured = 0;
  for (const Body& body : world.bodies) {
    EXPECT_TRUE(body.is_static) << body.name;
    for (const Shape& shape : body.visuals) textured += shape.material.texture != nullptr ? 1U : 0U;
  }
  EXPECT_GT(textured, 50U);
}

TEST_F(PublicWorldsTest, ArenasHaveTheirTwelveObjects) {
  for (const std::string kind : {"dev", "floor"}) {
    const World reference = load("toyota_wrs2020/worlds/" + kind + "_t0_reference.world");
    for (const std::string visit : {"t1", "t2"}) {
      const World world = load("toyota_wrs2020/worlds/" + kind + "_" + visit + ".world");
      EXPECT_EQ(world.bodies.size(), reference.bodies.size() + 12) << kind << visit;
      for (const Body& body : world.bodies) {
        EXPECT_FALSE(body.visuals.empty() && body.collisions.empty()) << body.name;
        if (body.name.find("ycb") != std::string::npos) {
          EXPECT_FALSE(body.is_static) << body.name;
          EXPECT_LT(bounds_in_world(body).sizes().maxCoeff(), 0.5) << body.name;
        }
      }
    }
  }
}

TEST_F(PublicWorldsTest, OtherFlatsLoad) {
  EXPECT_GT(load("toyota_tmc/worlds/hcr2013.world").bodies.size(), 20U);
  EXPECT_GT(load("toyota_tmc/worlds/apartment_no_objects.world").bodies.size(), 50U);
}

TEST_F(PublicWorldsTest, YcbObjectsHaveTheirBoxes) {
  std::ifstream in(data_ / "ycb/ycb_mesh_facts.json");
  const nlohmann::json facts = nlohmann::json::parse(in);
  std::size_t compared = 0;
  for (const auto& [name, fact] : facts.items()) {
    const fs::path folder = data_ / "ycb/models_light" / name;
    if (!fs::exists(folder)) continue;
    const Body body = load_model(folder);
    Eigen::AlignedBox3d drawn = bounds(body.visuals);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(drawn.sizes()(axis), fact["size"][static_cast<std::size_t>(axis)].get<double>(), 0.003)
          << name << axis;
      EXPECT_NEAR(drawn.min()(axis), fact["bbox_min"][static_cast<std::size_t>(axis)].get<double>(), 0.003)
          << name << axis;
    }
    EXPECT_NEAR(body.mass_kg, fact["mass"].get<double>(), 1e-6) << name;
    ++compared;
  }
  EXPECT_GT(compared, 70U);
}

TEST_F(PublicWorldsTest, TexturedAndPlainYcbMeshesAgree) {
  std::size_t compared = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(data_ / "ycb/models")) {
    fs::path textured, plain;
    for (const fs::directory_entry& file : fs::recursive_directory_iterator(entry.path())) {
      if (file.path().filename() == "textured.dae") textured = file.path();
      if (file.path().filename() == "nontextured.stl") plain = file.path();
    }
    if (textured.empty() || plain.empty()) continue;
    Eigen::AlignedBox3f a, b;
    const MeshFile coloured = load_mesh(textured);
    EXPECT_NE(coloured.parts.front().material.texture, nullptr) << textured;
    for (const MeshPart& part : coloured.parts) {
      for (const auto& v : part.mesh->vertices) a.extend(v);
    }
    for (const MeshPart& part : load_mesh(plain).parts) {
      for (const auto& v : part.mesh->vertices) b.extend(v);
    }
    EXPECT_LT((a.min() - b.min()).cwiseAbs().maxCoeff(), 0.003F) << entry.path();
    EXPECT_LT((a.max() - b.max()).cwiseAbs().maxCoeff(), 0.003F) << entry.path();
    ++compared;
  }
  EXPECT_GT(compared, 5U);
}

}  // namespace
}  // namespace amiss::world
