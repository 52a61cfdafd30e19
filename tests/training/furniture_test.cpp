#include "training/furniture.hpp"

#include <gtest/gtest.h>

#include "world/bounds.hpp"
#include "world/class_table.hpp"

namespace amiss::training {
namespace {

const world::ClassTable& classes() {
  static const world::ClassTable kTable =
      world::load_class_table(std::filesystem::path(AMISS_SOURCE_DIR) / "sim_worlds" / "classes.yaml");
  return kTable;
}

std::vector<FurnitureKind> all_kinds() {
  std::vector<FurnitureKind> kinds;
  for (const auto table : {seats(), storage(), decoration(), props()})
    kinds.insert(kinds.end(), table.begin(), table.end());
  return kinds;
}

TEST(Furniture, HasAClassAndAReasonableSize) {
  for (const FurnitureKind& kind : all_kinds()) {
    RandomStream random(1, kind.name);
    for (int i = 0; i < 30; ++i) {
      const world::Body body = kind.make(random);
      EXPECT_NE(classes().class_of(body.name), SemanticClass::kUnlabelled) << body.name;
      EXPECT_TRUE(body.is_static);
      const Eigen::AlignedBox3d box = world::bounds(body.visuals);
      EXPECT_GT(box.min().z(), -0.12) << kind.name;
      EXPECT_LT(box.max().z(), 2.5) << kind.name;
      EXPECT_GT(box.sizes().maxCoeff(), 0.03) << kind.name;
      EXPECT_LT(box.sizes().maxCoeff(), 3.2) << kind.name;
    }
  }
}

TEST(Furniture, WhatStandsOnFurnitureIsSmallAndOtherProp) {
  for (const FurnitureKind& kind : props()) {
    RandomStream random(2, kind.name);
    const world::Body body = kind.make(random);
    EXPECT_EQ(classes().class_of(body.name), SemanticClass::kOtherProp);
    EXPECT_EQ(kind.stand, Stand::kOnFurniture);
    EXPECT_LT(world::bounds(body.visuals).sizes().maxCoeff(), 1.0);
  }
}

TEST(Furniture, WhatHangsHasItsBackAtTheWall) {
  for (const FurnitureKind& kind : all_kinds()) {
    if (kind.stand != Stand::kOnWall) continue;
    RandomStream random(3, kind.name);
    EXPECT_GT(world::bounds(kind.make(random).visuals).min().x(), -0.02) << kind.name;
  }
}

TEST(Furniture, NoTwoAreAlike) {
  for (const FurnitureKind& kind : all_kinds()) {
    RandomStream random(4, kind.name);
    const auto size = [&]() -> Eigen::Vector3d { return world::bounds(kind.make(random).visuals).sizes(); };
    if (kind.name == "washing_machine") continue;
    EXPECT_NE(size(), size()) << kind.name;
  }
}

}  // namespace
}  // namespace amiss::training
