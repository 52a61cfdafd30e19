// SurfaceMap against voxblox's integrators, ray by ray (voxblox.hpp), on random scenes.
#include "mapping/voxblox.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "mapping/surface_scene.hpp"

namespace amiss::mapping {
namespace {

SurfaceParams coarse_params() {
  SurfaceParams params;
  params.voxel_m = 0.04;  // with a quarter of the pixels, what 1 cm is with all of them
  return params;
}

SurfaceRecording random_recording(RandomStream& random, int frames, bool noise) {
  const auto first = camera_pose(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-3, 3),
                                 random.uniform(-0.9, -0.2), random.uniform(0.7, 1.2));
  const TestScene scene = random_scene(random, first);
  SurfaceRecording r;
  for (int i = 0; i < frames; ++i) {
    auto pose = first;
    pose.T.translation() += Eigen::Vector3d(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0.0);
    pose.T.rotate(Eigen::AngleAxisd(random.uniform(-0.1, 0.1), Eigen::Vector3d::UnitY()));
    RgbdFrame frame = exact_frame(scene, pose, small_camera());
    if (noise) frame = noisy_frame(frame, random);
    paint(frame);
    r.poses.push_back(pose);
    r.frames.push_back(std::move(frame));
  }
  return r;
}

template <class M>
void insert_all(M& map, const SurfaceRecording& r) {
  for (std::size_t i = 0; i < r.frames.size(); ++i) map.insert(r.frames[i], r.poses[i]);
}

/// Sorted differences of the voxels that both know within half the truncation of the surface, and what the rays that
/// cross voxels which ours lacks weigh.
struct Agreement {
  std::vector<double> distance_voxels, weight_ratio, colour;
  double lost_weight = 0.0, weight = 0.0;
  double ours_s = 0.0, theirs_s = 0.0;  // of the processor

  void add(const SurfaceMap& ours, const Voxblox& theirs) {
    const double near = 0.5 * ours.params().truncation_m();
    for (const auto& [v, voxel] : theirs.voxels()) {
      if (std::abs(static_cast<double>(voxel.distance_m)) > near) continue;
      weight += static_cast<double>(voxel.weight);
      if (const auto other = ours.voxel(v)) {
        compare(*other, voxel, ours.params().voxel_m);
      } else {
        lost_weight += static_cast<double>(voxel.weight);
      }
    }
  }
  void compare(const SurfaceVoxel& a, const SurfaceVoxel& b, double voxel_m) {
    distance_voxels.push_back(static_cast<double>(std::abs(a.distance_m - b.distance_m)) / voxel_m);
    weight_ratio.push_back(static_cast<double>(a.weight / b.weight));
    const auto apart = [](int x, int y) { return std::abs(x - y); };
    colour.push_back(
        std::max({apart(a.colour.r, b.colour.r), apart(a.colour.g, b.colour.g), apart(a.colour.b, b.colour.b)}));
  }
  void sort() {
    for (auto* values : {&distance_voxels, &weight_ratio, &colour}) std::sort(values->begin(), values->end());
  }
};
double at(const std::vector<double>& sorted, double part) {
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}
double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Six random scenes of one to three frames each.
Agreement agreement_with(Voxblox::Method method, bool noise) {
  Agreement all;
  for (int seed = 0; seed < 6; ++seed) {
    RandomStream random(static_cast<std::uint64_t>(seed), "voxblox");
    const SurfaceRecording r = random_recording(random, 1 + seed % 3, noise);
    SurfaceMap ours(coarse_params());
    Voxblox theirs(coarse_params(), method);
    const double begin_s = processor_s();
    insert_all(ours, r);
    const double between_s = processor_s();
    insert_all(theirs, r);
    all.ours_s += between_s - begin_s;
    all.theirs_s += processor_s() - between_s;
    all.add(ours, theirs);
  }
  all.sort();
  return all;
}

/// The tolerance of the fast way. Distances: a tenth of a voxel in the middle, and half a voxel for all but a
/// twentieth, at edges of things. Weights: ours is the mean number of rays that cross a voxel, theirs the number of
/// this one. Lost: voxels that rays touch although their centre is hidden, beside the image or beyond the range.
void expect_agreement(const Agreement& a, double most_colour) {
  EXPECT_GT(a.distance_voxels.size(), 15000U);
  EXPECT_LT(at(a.distance_voxels, 0.5), 0.12);
  EXPECT_LT(at(a.distance_voxels, 0.95), 0.5);
  EXPECT_GT(at(a.weight_ratio, 0.05), 0.6);
  EXPECT_NEAR(at(a.weight_ratio, 0.5), 1.0, 0.15);
  EXPECT_LT(at(a.weight_ratio, 0.95), 1.7);
  EXPECT_LT(at(a.colour, 0.5), most_colour);
  EXPECT_LT(a.lost_weight, 0.03 * a.weight);
  EXPECT_GT(a.theirs_s, 10.0 * a.ours_s) << "the fast way is ten times as fast at least";
}

TEST(Voxblox, SimpleAgreesWithOurs) {
  expect_agreement(agreement_with(Voxblox::Method::kSimple, false), 8.0);
  expect_agreement(agreement_with(Voxblox::Method::kSimple, true), 8.0);
}

TEST(Voxblox, MergedAgreesWithOurs) {
  expect_agreement(agreement_with(Voxblox::Method::kMerged, false), 4.0);
  expect_agreement(agreement_with(Voxblox::Method::kMerged, true), 4.0);
}

/// What was carved free by rays is free for us, and nothing free is behind a surface of theirs.
TEST(Voxblox, CarvesTheSameSpace) {
  RandomStream random(1, "carved");
  std::size_t free = 0, agree = 0, ours_only = 0;
  for (int scene = 0; scene < 5; ++scene) {
    const SurfaceRecording r = random_recording(random, 2, false);
    SurfaceMap ours(coarse_params());
    Voxblox theirs(coarse_params(), Voxblox::Method::kSimple);
    insert_all(ours, r);
    insert_all(theirs, r);
    const double voxel = ours.params().voxel_m;
    for (const auto& [v, seen] : theirs.voxels()) {
      if (static_cast<double>(seen.distance_m) < 1.5 * voxel) continue;
      ++free;
      agree += ours.at(v) == Occupancy::kFree ? 1U : 0U;
    }
    for (const ValueBlock& b : ours.values().blocks()) {
      for_each_bit(b.key, b.known, [&](Voxel v) {
        const auto found = theirs.voxels().find(v);
        const bool theirs_free =
            found != theirs.voxels().end() && static_cast<double>(found->second.distance_m) > 0.5 * voxel;
        ours_only += ours.at(v) == Occupancy::kFree && !theirs_free ? 1U : 0U;
      });
    }
  }
  EXPECT_GT(free, 50000U);
  EXPECT_GT(static_cast<double>(agree), 0.85 * static_cast<double>(free)) << "all but the rim of the view";
  EXPECT_LT(static_cast<double>(ours_only), 0.02 * static_cast<double>(free));
}

}  // namespace
}  // namespace amiss::mapping
