#include "training/sampler.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "training/looks.hpp"
#include "training/made_up.hpp"
#include "training/piece.hpp"

namespace amiss::training {
namespace {

/// A floor with a low table on it.
world::World small_world() {
  world::World world;
  RandomStream random(1, "looks");
  world.bodies.push_back(Piece("floor").box({4, 4, 0.1}, {0, 0, -0.05}, random_wood(random)).take());
  world.bodies.push_back(Piece("table_1").box({0.8, 0.8, 0.5}, {1.2, 0, 0.25}, random_paint(random)).take());
  world.bodies.push_back(Piece("ceiling").box({0.3, 0.3, 0.3}, {0.9, 1.0, 0.15}, random_paint(random)).take());
  world.lights.push_back({});
  return world;
}

TEST(Sampler, PointsHaveTheClassOfWhatTheyLieOn) {
  RandomStream random(2, "sampler");
  const auto views = views_around({0, 0, 0}, 1.2);
  const LabelledCloud sampled = sampled_cloud(small_world(), test::classes(), views, {}, random);
  ASSERT_EQ(sampled.classes.size(), sampled.cloud.points.size());
  ASSERT_GT(sampled.classes.size(), 10000U);
  std::size_t floor = 0, table = 0, unlabelled = 0;
  for (std::size_t i = 0; i < sampled.classes.size(); ++i) {
    const Eigen::Vector3f& p = sampled.cloud.points[i];
    floor += sampled.classes[i] == SemanticClass::kFloor;
    table += sampled.classes[i] == SemanticClass::kTable;
    unlabelled += sampled.classes[i] == SemanticClass::kUnlabelled;
    const bool on_table = p.z() > 0.45F && p.z() < 0.52F && p.x() > 0.9F, on_floor = p.x() < 0.6F && p.z() < 0.05F;
    if (on_table || on_floor) {
      EXPECT_EQ(sampled.classes[i], on_table ? SemanticClass::kTable : SemanticClass::kFloor);
    }
  }
  EXPECT_GT(floor, 5000U);
  EXPECT_GT(table, 3000U);
  EXPECT_GT(unlabelled, 100U);  // the thing called ceiling
}

TEST(Sampler, OneStreamOneCloud) {
  const auto views = views_around({0, 0, 0}, 1.2);
  RandomStream a(3, "sampler"), b(3, "sampler");
  EXPECT_EQ(sampled_cloud(small_world(), test::classes(), views, {}, a).cloud.points,
            sampled_cloud(small_world(), test::classes(), views, {}, b).cloud.points);
}

TEST(Sampler, ViewsLookToBothSidesAndDown) {
  const auto views = views_around({1, 2, 0}, 1.1);
  ASSERT_EQ(views.size(), 6U);
  for (const auto& view : views) {
    EXPECT_NEAR(view.position().z(), 1.1, 1e-9);
    EXPECT_NEAR((view.position().head<2>() - Eigen::Vector2d(1, 2)).norm(), 0.1, 1e-9);
    EXPECT_LT((view.T.linear() * Eigen::Vector3d::UnitZ()).z(), -0.3);
  }
}

}  // namespace
}  // namespace amiss::training
