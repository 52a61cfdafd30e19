// What a frame costs the surface map (TSDF), beside plain voxblox-style ray casting of the same frames in the same
// program, and how far both agree. Times are of the processor, so that a busy neighbour does not count.
//   surface_bench [voxel in metres, 0.01] [frames, 6] [exact: depth without noise | ours: nothing but ours, ten times]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "mapping/surface_map.hpp"
#include "mapping/surface_scene.hpp"
#include "mapping/voxblox.hpp"

namespace {

using namespace amiss;
using namespace amiss::mapping;

double processor_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Milliseconds a frame.
template <class M>
double insert_all(M& map, const SurfaceRecording& r) {
  const double begin = processor_ms();
  for (std::size_t i = 0; i < r.frames.size(); ++i) map.insert(r.frames[i], r.poses[i]);
  return (processor_ms() - begin) / static_cast<double>(r.frames.size());
}

void compare(const char* name, double ms, double ours_ms, const SurfaceMap& ours, const Voxblox& theirs) {
  std::vector<double> apart;
  std::size_t missing = 0, band = 0;
  const double near = 0.5 * ours.params().truncation_m();
  for (const auto& [v, voxel] : theirs.voxels()) {
    if (std::abs(static_cast<double>(voxel.distance_m)) > near) continue;
    ++band;
    const auto other = ours.voxel(v);
    if (!other) {
      ++missing;
      continue;
    }
    apart.push_back(std::abs(static_cast<double>(other->distance_m) - static_cast<double>(voxel.distance_m)));
  }
  std::sort(apart.begin(), apart.end());
  const auto at = [&](double part) {
    return 1e3 * apart[static_cast<std::size_t>(part * static_cast<double>(apart.size() - 1))];
  };
  std::printf(
      "%-16s %9.1f ms a frame (%.0f times ours); distances near surfaces apart: median %.2f mm, 95 %% %.2f mm, "
      "99 %% %.2f mm; %.2f %% of its voxels unknown to ours\n",
      name, ms, ms / ours_ms, at(0.5), at(0.95), at(0.99),
      100.0 * static_cast<double>(missing) / static_cast<double>(band));
}

void error(const SurfaceMap& map) {
  double sum = 0.0;
  std::size_t n = 0;
  const TestScene scene = surface_scene();
  for (const ValueBlock& b : map.values().blocks()) {
    for_each_bit(b.key, b.occupied, [&](Voxel v) {
      const auto voxel = map.voxel(v);
      const auto here = map.sample(map.centre_of(v));
      if (!here || static_cast<double>(std::abs(voxel->distance_m)) > 0.5 * map.params().voxel_m) return;
      const Eigen::Vector3d p = map.centre_of(v) - (here->distance_m * here->gradient.normalized()).cast<double>();
      sum += std::pow(distance_to(scene, p), 2);
      ++n;
    });
  }
  std::printf("surface against the scene: rms %.2f mm over %zu voxels\n", 1e3 * std::sqrt(sum / static_cast<double>(n)),
              n);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string mode = argc > 3 ? argv[3] : "";
  SurfaceParams params;
  if (argc > 1) params.voxel_m = std::atof(argv[1]);
  const SurfaceRecording r = surface_recording(argc > 2 ? std::atoi(argv[2]) : 6, mode != "exact", CameraIntrinsics{});
  SurfaceMap warm(params);
  insert_all(warm, r);
  const double again_ms = insert_all(warm, r);
  SurfaceMap ours(params);
  const double ours_ms = insert_all(ours, r);
  std::printf(
      "surface map      %9.2f ms a frame (%.2f in a map that is there); %zu blocks, %zu of them near surfaces\n",
      ours_ms, again_ms, ours.values().blocks().size(), ours.surface_blocks());
  error(ours);
  if (mode == "ours") {
    for (int i = 0; i < 10; ++i) std::printf("again %.2f ms a frame\n", insert_all(ours, r));
    return 0;
  }
  for (const auto method : {Voxblox::Method::kSimple, Voxblox::Method::kMerged}) {
    Voxblox theirs(params, method);
    const double ms = insert_all(theirs, r);
    compare(method == Voxblox::Method::kSimple ? "voxblox simple" : "voxblox merged", ms, ours_ms, ours, theirs);
  }
  return 0;
}
