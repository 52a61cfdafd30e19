#include "knowledge/internal/same_region.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace amiss::knowledge::internal {
namespace {

/// Counts cells of a fine grid: slow and obvious.
double shared_part_by_counting(const Cylinder& a, const Cylinder& b) {
  const Cylinder& small = a.radius_m <= b.radius_m ? a : b;
  const Cylinder& large = a.radius_m <= b.radius_m ? b : a;
  int inside = 0, both = 0;
  for (int i = 0; i < 400; ++i) {
    for (int j = 0; j < 400; ++j) {
      const Eigen::Vector2d p =
          small.centre_map + small.radius_m * Eigen::Vector2d((i + 0.5) / 200.0 - 1.0, (j + 0.5) / 200.0 - 1.0);
      if ((p - small.centre_map).norm() > small.radius_m) continue;
      ++inside;
      both += (p - large.centre_map).norm() <= large.radius_m ? 1 : 0;
    }
  }
  return static_cast<double>(both) / inside;
}

Cylinder any_cylinder() {
  return {{*rc::gen::inRange(-50, 50) / 100.0, *rc::gen::inRange(-50, 50) / 100.0},
          *rc::gen::inRange(2, 60) / 100.0,
          0.0,
          *rc::gen::inRange(1, 50) / 100.0};
}

RC_GTEST_PROP(SharedPart, AgreesWithCounting, ()) {
  const Cylinder a = any_cylinder(), b = any_cylinder();
  RC_ASSERT(std::abs(shared_part(a, b) - shared_part_by_counting(a, b)) < 0.01);
  RC_ASSERT(shared_part(a, b) == shared_part(b, a));
}

RC_GTEST_PROP(Enclosing, HoldsBothAndIsNoLargerThanNeeded, ()) {
  const Cylinder a = any_cylinder(), b = any_cylinder(), both = enclosing(a, b);
  for (const Cylinder& one : {a, b}) {
    RC_ASSERT((both.centre_map - one.centre_map).norm() + one.radius_m <= both.radius_m + 1e-9);
    RC_ASSERT(both.z_high_m >= one.z_high_m);
  }
  const double d = (a.centre_map - b.centre_map).norm();
  RC_ASSERT(both.radius_m <= std::max({a.radius_m, b.radius_m, (d + a.radius_m + b.radius_m) / 2.0}) + 1e-9);
}

RC_GTEST_PROP(Joined, DoesNotDependOnTheOrderAndLeavesNoTwoOfOneRegion, ()) {
  std::vector<Sighting> sightings;
  const int n = *rc::gen::inRange(0, 10);
  for (int i = 0; i < n; ++i) {
    const Cylinder c = any_cylinder();
    sightings.push_back({{2.0 * c.centre_map.x(), c.centre_map.y(), c.z_high_m / 2.0}, c, i + 4});
  }
  const auto once = joined(sightings, {});
  std::reverse(sightings.begin(), sightings.end());
  const auto reversed = joined(sightings, {});
  RC_ASSERT(once.size() == reversed.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    RC_ASSERT(once[i].cylinder == reversed[i].cylinder);
    for (std::size_t j = i + 1; j < once.size(); ++j) {
      RC_ASSERT(!same_region(once[i].cylinder, once[j].cylinder, {}));
    }
  }
}

TEST(GrownNoticeably, NeedsBothAPartAndALength) {
  const Cylinder small{{0, 0}, 0.05, 0.0, 0.05};
  EXPECT_FALSE(grown_noticeably(small, {{0, 0}, 0.10, 0.0, 0.10}, {}));
  EXPECT_TRUE(grown_noticeably(small, {{0, 0}, 0.16, 0.0, 0.05}, {}));
  EXPECT_TRUE(grown_noticeably(small, {{0, 0}, 0.05, 0.0, 0.20}, {}));
  const Cylinder large{{0, 0}, 1.0, 0.0, 0.05};
  EXPECT_FALSE(grown_noticeably(large, {{0, 0}, 1.11, 0.0, 0.05}, {}));
}

}  // namespace
}  // namespace amiss::knowledge::internal
