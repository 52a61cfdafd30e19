#include "semantics/rendered_labeller.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/result.hpp"

namespace amiss::semantics {
namespace {

using C = SemanticClass;

/// A floor of 2 x 2 m in steps of 1 cm: table where x > 1.
RenderedLabeller::Truth two_halves() {
  RenderedLabeller::Truth truth;
  for (int x = 0; x < 200; ++x) {
    for (int y = 0; y < 200; ++y) {
      truth.points.emplace_back(static_cast<float>(x) * 0.01F + 0.005F, static_cast<float>(y) * 0.01F + 0.005F, 0.0F);
      truth.classes.push_back(x < 100 ? C::kFloor : C::kTable);
    }
  }
  return truth;
}
Cloud<Map> cloud_of(const RenderedLabeller::Truth& truth) { return {truth.points, {}, {}}; }

/// Floor is always taken for wall, table for bed in half of the cases.
Confusion some_confusion() {
  Confusion confusion;
  confusion.add(C::kFloor, C::kWall, 10);
  confusion.add(C::kTable, C::kTable, 5);
  confusion.add(C::kTable, C::kBed, 5);
  return confusion;
}

double share(const std::vector<C>& classes, C value) {
  return static_cast<double>(std::count(classes.begin(), classes.end(), value)) / static_cast<double>(classes.size());
}

TEST(RenderedLabeller, UnspoiledIsTheTruth) {
  const RenderedLabeller labeller(two_halves(), some_confusion(), {}, 1);
  EXPECT_EQ(labeller.label(cloud_of(two_halves())), two_halves().classes);
}

TEST(RenderedLabeller, SaysThatItIsNotLearned) {
  const LabellerIdentity identity = RenderedLabeller(two_halves(), {}, {}, 1).identity();
  EXPECT_EQ(identity.kind, "rendered");
  EXPECT_FALSE(identity.learned);
  EXPECT_NE(identity.to_line().find("not learned"), std::string::npos);
}

TEST(RenderedLabeller, FarPointsAreUnlabelled) {
  const RenderedLabeller labeller(two_halves(), {}, {}, 1);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Cloud<Map> cloud{{{0.5F, 0.5F, 0.04F}, {0.5F, 0.5F, 0.06F}, {nan, 0, 0}, {1e30F, 0, 0}}, {}, {}};
  EXPECT_EQ(labeller.label(cloud), (std::vector<C>{C::kFloor, C::kUnlabelled, C::kUnlabelled, C::kUnlabelled}));
}

TEST(RenderedLabeller, BlurFraysTheBorderOnly) {
  const auto truth = two_halves();
  const auto classes = RenderedLabeller(truth, {}, SpoilParams{.blur_m = 0.02}, 1).label(cloud_of(truth));
  std::size_t near = 0, near_wrong = 0, far_wrong = 0;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const float distance = std::abs(truth.points[i].x() - 1.0F);
    const bool wrong = classes[i] != truth.classes[i];
    if (distance < 0.02F) {
      ++near;
      near_wrong += wrong;
    }
    if (distance > 0.12F) far_wrong += wrong;
  }
  EXPECT_EQ(far_wrong, 0U);
  EXPECT_GT(static_cast<double>(near_wrong), 0.15 * static_cast<double>(near));
  EXPECT_LT(static_cast<double>(near_wrong), 0.5 * static_cast<double>(near));
}

TEST(RenderedLabeller, ConfusionFollowsTheMatrixAsFarAsItsStrength) {
  const auto truth = two_halves();
  const auto at = [&](double strength) {
    const SpoilParams params{.confusion_strength = strength, .patch_m = 0.05};
    return RenderedLabeller(truth, some_confusion(), params, 3).label(cloud_of(truth));
  };
  const auto full = at(1.0), half = at(0.5);
  EXPECT_EQ(share(full, C::kFloor), 0.0);
  EXPECT_DOUBLE_EQ(share(full, C::kWall), 0.5);
  EXPECT_NEAR(share(full, C::kBed), 0.25, 0.03);
  EXPECT_NEAR(share(half, C::kWall), 0.25, 0.03);
  EXPECT_NEAR(share(half, C::kBed), 0.125, 0.03);
}

TEST(RenderedLabeller, SeedsDiffer) {
  const auto truth = two_halves();
  const SpoilParams params{.blur_m = 0.03, .confusion_strength = 0.5};
  const auto with = [&](std::uint64_t seed) {
    return RenderedLabeller(truth, some_confusion(), params, seed).label(cloud_of(truth));
  };
  EXPECT_EQ(with(1), with(1));
  EXPECT_NE(with(1), with(2));
}

TEST(RenderedLabeller, BadInputIsRefused) {
  EXPECT_THROW(RenderedLabeller(two_halves(), {}, SpoilParams{.blur_m = -1}, 1), ArgumentError);
  EXPECT_THROW(RenderedLabeller({{{0, 0, 0}}, {}}, {}, {}, 1), ArgumentError);
  Cloud<Map> cloud = cloud_of(two_halves());
  cloud.colours.resize(3);
  EXPECT_THROW((void)RenderedLabeller(two_halves(), {}, {}, 1).label(cloud), ArgumentError);
}

}  // namespace
}  // namespace amiss::semantics
