#include "sim/depth_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/result.hpp"
#include "sim/camera_fixture.hpp"

namespace amiss::sim {
namespace {

CameraIntrinsics small_camera() { return {320, 240, 538.39, 538.09, 157.0, 117.0}; }

/// A wall at one distance whose every pixel meets the ray under one angle.
RenderedFrame wall(double z_m, double a_rad, const CameraIntrinsics& c = small_camera()) {
  const std::size_t count = static_cast<std::size_t>(c.width) * static_cast<std::size_t>(c.height);
  RenderedFrame frame;
  frame.intrinsics = c;
  frame.colour.assign(count, {100, 120, 140});
  frame.depth_m.assign(count, static_cast<float>(z_m));
  frame.instances.assign(count, 1);
  frame.incidence.assign(count, static_cast<std::uint8_t>(std::lround(255.0 * std::cos(a_rad))));
  frame.reflectance.assign(count, 160);
  return frame;
}

RgbdFrame noisy(RenderedFrame frame, const DepthNoiseParams& params = {}, std::uint64_t seed = 1) {
  RandomStream stream(seed, "test");
  const CameraIntrinsics c = frame.intrinsics;
  return DepthNoise(params, c).apply(std::move(frame), {}, stream);
}

struct Statistics {
  double mean = 0.0, sigma = 0.0, lost = 0.0;
};

Statistics of(const std::vector<float>& depth) {
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (const float z : depth)
    if (!std::isnan(z)) count += 1.0, sum += static_cast<double>(z);
  for (const float z : depth)
    if (!std::isnan(z)) squares += std::pow(static_cast<double>(z) - sum / count, 2.0);
  return {sum / count, std::sqrt(squares / count), 1.0 - count / static_cast<double>(depth.size())};
}

/// The slow and obvious way: one pixel after the other by the equations of the paper.
Statistics oracle(double z_m, double a_rad) {
  const DepthNoiseParams p;
  const CameraIntrinsics c = small_camera();
  RandomStream random(5, "oracle");
  const double steps_m = c.fx * p.baseline_m / p.disparity_step_px;
  std::vector<float> depth;
  for (int i = 0; i < 60000; ++i) {
    const double sigma_steps = sigma_axial_m(z_m, a_rad) * steps_m / (z_m * z_m);
    const double before = std::sqrt(std::max(sigma_steps * sigma_steps - 1.0 / 12.0, 0.0));
    const double step = std::round(steps_m / z_m + before * random.normal());
    depth.push_back(static_cast<float>(steps_m / step));
  }
  return of(depth);
}

TEST(DepthNoise, SpreadsAsTheOracleAndThePaperSay) {
  for (const double z : {0.61, 1.03, 1.52, 2.07, 3.01})
    for (const double a_deg : {2.0, 31.0, 61.0, 73.0}) {
      const double a = radians(a_deg);
      const Statistics fast = of(noisy(wall(z, a)).depth_m), slow = oracle(z, a);
      EXPECT_NEAR(fast.mean, slow.mean, 0.06 * slow.sigma + 3e-4) << z << " " << a_deg;
      EXPECT_NEAR(fast.sigma, slow.sigma, 0.08 * slow.sigma) << z << " " << a_deg;
      EXPECT_NEAR(fast.sigma, sigma_axial_m(z, a), 0.15 * sigma_axial_m(z, a) + 1e-4) << z << " " << a_deg;
      EXPECT_LT(fast.lost, 0.01);
    }
}

TEST(DepthNoise, DepthIsAMultipleOfTheDisparityStep) {
  const RgbdFrame frame = noisy(wall(2.5, 0.3));
  const double steps_m = small_camera().fx * 0.075 / 0.125;
  for (const float z : frame.depth_m) {
    if (std::isnan(z)) continue;
    const double steps = steps_m / static_cast<double>(z);
    ASSERT_NEAR(steps, std::round(steps), 1e-3);
  }
}

TEST(DepthNoise, NothingComesBackFromTooNearTooFarOrTooFlat) {
  EXPECT_EQ(of(noisy(wall(0.35, 0.0)).depth_m).lost, 1.0);
  EXPECT_EQ(of(noisy(wall(9.0, 0.0)).depth_m).lost, 1.0);
  EXPECT_EQ(of(noisy(wall(1.0, radians(82))).depth_m).lost, 1.0);
  EXPECT_LT(of(noisy(wall(1.0, radians(78))).depth_m).lost, 0.01);
  RenderedFrame sky = wall(2.0, 0.0);
  sky.depth_m.assign(sky.depth_m.size(), std::nanf(""));
  EXPECT_EQ(of(noisy(std::move(sky)).depth_m).lost, 1.0);
}

TEST(DepthNoise, DarkAndShinySurfacesDropOutWithDistance) {
  const auto lost = [](double z, std::uint8_t reflectance) {
    RenderedFrame frame = wall(z, radians(30));
    frame.reflectance.assign(frame.reflectance.size(), reflectance);
    return of(noisy(std::move(frame)).depth_m).lost;
  };
  EXPECT_LT(lost(1.0, 4), 0.01);
  EXPECT_GT(lost(3.0, 2), 0.5);
  EXPECT_EQ(lost(1.0, 0), 1.0);
  // Half are lost at the least signal: reflectance 4 of 255 at cos(30 deg) / z^2.
  EXPECT_NEAR(lost(std::sqrt(4.0 / 255.0 * std::cos(radians(30)) / 0.001), 4), 0.5, 0.03);
}

/// A post in front of a wall, columns [150, 180) of the picture.
RenderedFrame post(double post_m, double wall_m) {
  RenderedFrame frame = wall(wall_m, 0.0);
  for (int v = 0; v < 240; ++v)
    for (int u = 150; u < 180; ++u) frame.depth_m[pixel(frame.intrinsics, u, v)] = static_cast<float>(post_m);
  return frame;
}

double share_lost(const RgbdFrame& frame, int from, int to) {
  int lost = 0;
  for (int v = 20; v < 220; ++v)
    for (int u = from; u < to; ++u) lost += std::isnan(frame.depth_m[pixel(frame.intrinsics, u, v)]) ? 1 : 0;
  return lost / (200.0 * (to - from));
}

TEST(DepthNoise, ThePostHidesTheWallFromTheProjectorOnItsLeft) {
  // Disparities of 40.4 and 20.2 px: the wall seen at u is lit at u - 20.2, the post covers [109.6, 139.6) there, so
  // the shadow lies at u in [129.8, 159.8), of which the post itself hides the part from 150 on.
  const RgbdFrame frame = noisy(post(1.0, 2.0));
  EXPECT_GT(share_lost(frame, 134, 146), 0.98);
  EXPECT_LT(share_lost(frame, 100, 126), 0.02);
  EXPECT_LT(share_lost(frame, 184, 230), 0.02);
  EXPECT_LT(share_lost(frame, 156, 174), 0.02);
}

TEST(DepthNoise, AThinPostThrowsAThinShadow) {
  RenderedFrame frame = wall(2.0, 0.0);
  for (int v = 0; v < 240; ++v)
    for (int u = 150; u < 156; ++u) frame.depth_m[pixel(frame.intrinsics, u, v)] = 1.0F;
  const RgbdFrame seen = noisy(std::move(frame));  // dark in [129.8, 135.8), lit between that and the post
  EXPECT_GT(share_lost(seen, 131, 135), 0.9);
  EXPECT_LT(share_lost(seen, 139, 146), 0.02);
}

TEST(DepthNoise, EdgesWobbleByTheLateralSigma) {
  DepthNoiseParams params;
  params.baseline_m = 0.075;
  params.edge_loss = params.random_loss = 0.0;
  const RgbdFrame frame = noisy(post(1.0, 1.4), params);  // its right edge lies between columns 179 and 180
  double outside = 0.0;
  for (int v = 20; v < 220; ++v)
    for (int u = 180; u < 186; ++u) outside += frame.depth_m[pixel(frame.intrinsics, u, v)] < 1.2F ? 1.0 : 0.0;
  // Pixels k right of the edge show the post where the shift, rounded to pixels, is less than -k.
  double expected = 0.0;
  for (int k = 0; k < 6; ++k) expected += 100.0 * std::erfc((k + 0.5) / sigma_lateral_px(0.0) / std::sqrt(2.0));
  EXPECT_NEAR(outside, expected, 0.25 * expected);
}

TEST(DepthNoise, ColourNoiseHasTheSigmaAskedFor) {
  const RgbdFrame frame = noisy(wall(1.0, 0.0));
  double squares = 0.0;
  for (const Rgb& c : frame.colour) squares += std::pow(c.g - 120.0, 2.0);
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(frame.colour.size())), 2.5, 0.2);
}

TEST(DepthNoise, TheSameStreamGivesTheSameFrame) {
  const RgbdFrame a = noisy(wall(2.0, 0.5), {}, 3), b = noisy(wall(2.0, 0.5), {}, 3), c = noisy(wall(2.0, 0.5), {}, 4);
  EXPECT_EQ(a.colour, b.colour);
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.depth_m.size(); ++i) {
    EXPECT_TRUE(a.depth_m[i] == b.depth_m[i] || (std::isnan(a.depth_m[i]) && std::isnan(b.depth_m[i])));
    different += a.depth_m[i] != c.depth_m[i] ? 1U : 0U;
  }
  EXPECT_GT(different, a.depth_m.size() / 2);
}

TEST(DepthNoise, SwitchedOffItPassesTheFrameOn) {
  DepthNoiseParams params;
  params.enabled = false;
  const RgbdFrame frame = noisy(wall(1.234, 0.0), params);
  EXPECT_EQ(frame.depth_m, wall(1.234, 0.0).depth_m);
  EXPECT_EQ(frame.colour, wall(1.234, 0.0).colour);
}

TEST(DepthNoise, RefusesContradictions) {
  DepthNoiseParams params;
  params.min_range_m = 9.0;
  EXPECT_THROW(DepthNoise(params, small_camera()), ArgumentError);
  RandomStream stream(1, "test");
  EXPECT_THROW((void)DepthNoise({}, CameraIntrinsics{}).apply(wall(1.0, 0.0), {}, stream), ArgumentError);
}

TEST(DepthNoise, EveryParameterHasARowAndTheDefaultsAreAllowed) {
  ParamTable table;
  DepthNoiseParams params;
  describe(table, params);
  EXPECT_EQ(table.rows().size(), 13U);
  for (const auto& row : table.rows()) EXPECT_TRUE(row.parse(row.print())) << row.key;
}

}  // namespace
}  // namespace amiss::sim
