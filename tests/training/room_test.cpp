#include "training/room.hpp"

#include <gtest/gtest.h>

#include <set>

#include "training/made_up.hpp"
#include "world/bounds.hpp"

namespace amiss::training {
namespace {

TEST(TrainingRoom, HasFurnitureAndObjectsWithinItsWalls) {
  std::size_t objects = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    RandomStream random(seed, "room");
    const TrainingRoom room = random_room(test::toys(), random);
    EXPECT_GT(room.world.bodies.size(), 12U);
    objects += room.objects;
    for (const world::Body& body : room.world.bodies) {
      EXPECT_NE(test::classes().class_of(body.name), SemanticClass::kUnlabelled) << body.name;
      const Eigen::AlignedBox3d box = world::bounds_in_world(body);
      EXPECT_GT(box.min().head<2>().minCoeff(), -0.3) << body.name;
      EXPECT_LT((box.max().head<2>() - room.size_m).maxCoeff(), 0.3) << body.name;
    }
  }
  EXPECT_GT(objects, 40U);
}

TEST(TrainingRoom, NamesAreUnique) {
  RandomStream random(3, "room");
  std::set<std::string> names;
  const TrainingRoom room = random_room(test::toys(), random);
  for (const world::Body& body : room.world.bodies) EXPECT_TRUE(names.insert(body.name).second) << body.name;
}

TEST(TrainingRoom, ObjectsLieOnSomething) {
  RandomStream random(4, "room");
  const TrainingRoom room = random_room(test::toys(), random);
  for (const world::Body& body : room.world.bodies) {
    if (!body.name.starts_with("storage_box_")) continue;
    const double z = world::bounds_in_world(body).min().z();
    EXPECT_GE(z, 0.0) << body.name;
    if (z < 0.01) continue;  // on the floor
    bool carried = false;
    for (const world::Body& other : room.world.bodies) {
      for (const world::Shape& shape : other.collisions) {
        const Eigen::AlignedBox3d box = world::bounds(shape.geometry, other.pose.T * shape.T_body_shape);
        carried |= std::abs(box.max().z() - z) < 0.002 && box.intersects(world::bounds_in_world(body));
        carried |= std::abs(box.max().z() + 0.001 - z) < 0.002;
      }
    }
    EXPECT_TRUE(carried) << body.name;
  }
}

TEST(TrainingRoom, FreePlacesAreClearOfFurniture) {
  RandomStream random(5, "room");
  const TrainingRoom room = random_room({}, random);
  EXPECT_EQ(room.objects, 0U);
  EXPECT_FALSE(room.is_free({-1, 1}, 0.2));
  for (const world::Body& body : room.world.bodies) {
    const Eigen::AlignedBox3d box = world::bounds_in_world(body);
    if (!body.name.starts_with("cabinet")) continue;
    EXPECT_FALSE(room.is_free(box.center().head<2>(), 0.2));
  }
}

TEST(TrainingRoom, OneStreamOneRoom) {
  RandomStream a(6, "room"), b(6, "room");
  const TrainingRoom one = random_room(test::toys(), a), other = random_room(test::toys(), b);
  ASSERT_EQ(one.world.bodies.size(), other.world.bodies.size());
  for (std::size_t i = 0; i < one.world.bodies.size(); ++i) {
    EXPECT_EQ(one.world.bodies[i].name, other.world.bodies[i].name);
    EXPECT_EQ(one.world.bodies[i].pose.T.matrix(), other.world.bodies[i].pose.T.matrix());
  }
}

}  // namespace
}  // namespace amiss::training
