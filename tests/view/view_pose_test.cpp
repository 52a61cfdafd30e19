#include "view/view_pose.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/random.hpp"
#include "motion/test_flat.hpp"
#include "view/test_head.hpp"

namespace amiss::view {
namespace {

const SightTest kClear = [](const Eigen::Vector3d&, const Eigen::Vector3d&) { return true; };

std::vector<float> travel_from(const FloorGrid& grid, const Eigen::Vector2d& robot) {
  const auto gap = distance_to_occupied_m(grid, true);
  std::vector<float> travel(gap.size(), std::numeric_limits<float>::infinity());
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const std::size_t i = grid.index({x, y});
      if (gap[i] >= 0.325F) travel[i] = static_cast<float>((grid.centre_of({x, y}) - robot).norm());
    }
  }
  return travel;
}

constexpr double kGap_m = 1e-9;

void expect_good_view(const ViewPose& view, const Cylinder& region, const FloorGrid& grid,
                      const std::vector<float>& travel, const PoseParams& params) {
  const Head head = test_head();
  const Eigen::Vector2d to = region.middle_m.head<2>() - view.T_map_base.position();
  EXPECT_GE(to.norm() - region.radius_m, params.exam_dist_m - kGap_m);
  EXPECT_LE(to.norm() - region.radius_m, params.max_dist_m + kGap_m);
  EXPECT_TRUE(std::isfinite(travel[grid.index(grid.cell_at(view.T_map_base.position()))]));
  EXPECT_NEAR(wrap_angle(view.T_map_base.yaw_rad - std::atan2(to.y(), to.x())), 0.0, 1e-9);
  const robot::HeadState state{view.pan_rad, view.tilt_rad};
  EXPECT_LT((pixel_of(head, view.T_map_base, state, region.middle_m) - Eigen::Vector2d(319.5, 239.5)).norm(), 1.0);
  const auto T_camera_map = (view.T_map_base.lift() * head.T_base_camera(state)).inverse();
  for (int i = 0; i < 36; ++i) {
    const double angle = radians(10.0 * i), radius = region.radius_m + params.margin_m;
    for (const double z : {0.0, region.middle_m.z() + 0.5 * region.height_m + params.margin_m}) {
      const Eigen::Vector3d p = region.middle_m + Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle),
                                                                  z - region.middle_m.z());
      EXPECT_GE((T_camera_map.T * p).z(), 0.4);
      const Eigen::Vector2d pixel = pixel_of(head, view.T_map_base, state, p);
      EXPECT_GE(pixel.minCoeff(), 0.0);
      EXPECT_LE(pixel.x(), 639.0);
      EXPECT_LE(pixel.y(), 479.0);
    }
  }
}

TEST(ViewPoses, AreARingRoundARegionInTheOpen) {
  const FloorGrid grid = empty_room(6.0, 6.0);
  const auto travel = travel_from(grid, {1.0, 3.0});
  const Cylinder region{{3.0, 3.0, 0.05}, 0.08, 0.10};
  const auto views = view_poses(region, grid, travel, kClear, test_head(), {});
  ASSERT_EQ(views.size(), 6U);
  for (std::size_t i = 0; i < views.size(); ++i) {
    expect_good_view(views[i], region, grid, travel, {});
    EXPECT_EQ(views[i].clear_share, 1.0);
    EXPECT_NEAR((views[i].T_map_base.position() - Eigen::Vector2d(3.0, 3.0)).norm(), 0.68, 1e-9);
    EXPECT_GE(views[i].cost, views[i == 0 ? 0 : i - 1].cost);
  }
  EXPECT_LT(views[0].T_map_base.x_m, 3.0);  // the near side first
}

RC_GTEST_PROP(ViewPoses, AreReachableAndSeeTheWholeRegion, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), "poses");
  const FloorGrid grid = test_flat();
  const auto travel = travel_from(grid, {4.0, 4.0});
  const double x = random.uniform(0.3, 11.7), y = random.uniform(0.3, 7.2), height = random.uniform(0.03, 0.4);
  const Cylinder region{{x, y, 0.5 * height}, random.uniform(0.03, 0.3), height};
  for (const ViewPose& view : view_poses(region, grid, travel, kClear, test_head(), {})) {
    expect_good_view(view, region, grid, travel, {});
    RC_ASSERT(!::testing::Test::HasFailure());
  }
}

TEST(ViewPoses, AvoidPlacesBehindSomething) {
  const FloorGrid grid = empty_room(6.0, 6.0);
  const auto travel = travel_from(grid, {1.0, 3.0});
  const Cylinder region{{3.0, 3.0, 0.05}, 0.08, 0.10};
  // A screen at x = 2.7 hides the region from the left.
  const SightTest screen = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (a.x() - 2.75) * (b.x() - 2.75) > 0.0;
  };
  const auto views = view_poses(region, grid, travel, screen, test_head(), {});
  ASSERT_FALSE(views.empty());
  EXPECT_LT(views.size(), 6U);
  for (const ViewPose& view : views) EXPECT_GT(view.T_map_base.x_m, 2.7);
  const SightTest nothing = [](const Eigen::Vector3d&, const Eigen::Vector3d&) { return false; };
  EXPECT_TRUE(view_poses(region, grid, travel, nothing, test_head(), {}).empty());
}

TEST(ViewPoses, GoFartherAwayWhereTheIdealRingIsBlocked) {
  const FloorGrid grid = empty_room(6.0, 6.0);
  auto travel = travel_from(grid, {1.0, 3.0});
  const Eigen::Vector2d middle(3.0, 3.0);
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if ((grid.centre_of({x, y}) - middle).norm() < 0.9)
        travel[grid.index({x, y})] = std::numeric_limits<float>::infinity();
    }
  }
  const Cylinder region{{3.0, 3.0, 0.05}, 0.08, 0.10};
  const auto views = view_poses(region, grid, travel, kClear, test_head(), {});
  ASSERT_EQ(views.size(), 6U);
  for (const ViewPose& view : views) {
    EXPECT_GE((view.T_map_base.position() - middle).norm(), 0.85);
    expect_good_view(view, region, grid, travel, {});
  }
}

TEST(ViewPoses, AreFewerInACorner) {
  const FloorGrid grid = empty_room(6.0, 6.0);
  const auto travel = travel_from(grid, {3.0, 3.0});
  const Cylinder region{{0.2, 0.2, 0.05}, 0.08, 0.10};
  const auto views = view_poses(region, grid, travel, kClear, test_head(), {});
  EXPECT_GE(views.size(), 1U);
  EXPECT_LE(views.size(), 3U);
  for (const ViewPose& view : views) expect_good_view(view, region, grid, travel, {});
}

}  // namespace
}  // namespace amiss::view
