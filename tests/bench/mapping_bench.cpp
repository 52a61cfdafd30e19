// What a frame costs the voxel map, beside plain OctoMap on the same frames, and how far both agree; what a difference
// costs. Times are of the processor, so that a busy neighbour does not count.
//   mapping_bench [--benchmark_filter=...]
#include <benchmark/benchmark.h>
#include <octomap/octomap.h>

#include <cmath>

#include "change/difference.hpp"
#include "change/region.hpp"
#include "mapping/synthetic.hpp"
#include "mapping/voxel_map.hpp"

namespace {

using namespace amiss;
using namespace amiss::mapping;

struct Recording {
  std::vector<RgbdFrame> frames;
  std::vector<Transform<Map, Camera>> poses;
};

TestScene room() {
  TestScene scene;
  scene.boxes = {{{3.02, -3, -0.012}, {3.1, 3, 2.4}},      {{-1, 2.01, -0.012}, {3, 2.1, 2.4}},
                 {{1.03, 0.8, 0.38}, {1.82, 1.52, 0.42}},  {{1.05, 0.83, -0.012}, {1.09, 0.87, 0.4}},
                 {{2.2, -1.7, -0.012}, {2.9, -0.6, 0.45}}, {{1.5, 0.02, -0.012}, {1.52, 0.14, 0.008}}};
  scene.balls = {{{1.9, -0.3, 0.0205}, 0.0325}};
  return scene;
}

const Recording& recording() {
  static const Recording made = [] {
    Recording r;
    RandomStream random(1, "bench");
    for (int i = 0; i < 24; ++i) {
      r.poses.push_back(camera_pose(-0.5 + 0.06 * i, -0.3 + 0.02 * i, -0.5 + 0.08 * i, -0.55));
      r.frames.push_back(noisy_frame(exact_frame(room(), r.poses.back()), random));
    }
    return r;
  }();
  return made;
}

VoxelMapParams params_of(const char* store, int pixel_step) {
  VoxelMapParams params;
  params.store = store;
  params.pixel_step = pixel_step;
  return params;
}

void insert_ours(benchmark::State& state, const char* store) {
  const Recording& r = recording();
  const VoxelMapParams params = params_of(store, static_cast<int>(state.range(0)));
  for (auto _ : state) {
    VoxelMap map(params);
    for (std::size_t i = 0; i < r.frames.size(); ++i) map.insert(r.frames[i], r.poses[i]);
    benchmark::DoNotOptimize(map.revision());
  }
  state.counters["ms_a_frame"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(r.frames.size()) / 1e3,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

octomap::Pointcloud cloud_of(const RgbdFrame& frame, const Transform<Map, Camera>& pose, const VoxelMapParams& p) {
  octomap::Pointcloud cloud;
  const CameraIntrinsics& k = frame.intrinsics;
  for (int v = 0; v < k.height; v += p.pixel_step) {
    for (int u = 0; u < k.width; u += p.pixel_step) {
      const double z = static_cast<double>(frame.depth_m[static_cast<std::size_t>(v * k.width + u)]);
      if (!(z >= p.min_range_m && z <= p.max_hit_range_m)) continue;
      const Eigen::Vector3f q =
          (pose.T * Eigen::Vector3d((u - k.cx) / k.fx * z, (v - k.cy) / k.fy * z, z)).cast<float>();
      cloud.push_back(q.x(), q.y(), q.z());
    }
  }
  return cloud;
}

void insert_plain(octomap::OcTree& tree, const Recording& r, const VoxelMapParams& params, bool discretized) {
  for (std::size_t i = 0; i < r.frames.size(); ++i) {
    const Eigen::Vector3f o = r.poses[i].position().cast<float>();
    tree.insertPointCloud(cloud_of(r.frames[i], r.poses[i], params), octomap::point3d(o.x(), o.y(), o.z()), -1.0, false,
                          discretized);
  }
}

void insert_octomap(benchmark::State& state, bool discretized) {
  const Recording& r = recording();
  const VoxelMapParams params = params_of("blocks", static_cast<int>(state.range(0)));
  VoxelMapParams any_hit = params;  // OctoMap's rule, so that the maps can be compared
  any_hit.min_end_points = 1;
  any_hit.min_end_fraction = 0.0;
  VoxelMap ours(any_hit);
  for (std::size_t i = 0; i < r.frames.size(); ++i) ours.insert(r.frames[i], r.poses[i]);
  for (auto _ : state) {
    octomap::OcTree tree(params.resolution_m);
    insert_plain(tree, r, params, discretized);
    state.PauseTiming();
    tree.expand();
    double both = 0, either = static_cast<double>(ours.counts().occupied);
    for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
      if (!tree.isNodeOccupied(*leaf)) continue;
      const bool agreed = ours.at(Eigen::Vector3d(leaf.getX(), leaf.getY(), leaf.getZ())) == Occupancy::kOccupied;
      both += agreed ? 1.0 : 0.0;
      either += agreed ? 0.0 : 1.0;
    }
    state.counters["occupied_iou"] = both / either;
    state.ResumeTiming();
  }
  state.counters["ms_a_frame"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(r.frames.size()) / 1e3,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void difference_by_frame(benchmark::State& state) {
  const Recording& r = recording();
  VoxelMap reference;
  for (std::size_t i = 0; i < r.frames.size(); ++i) reference.insert(r.frames[i], r.poses[i]);
  const VoxelMap grown = dilated(reference, 1);
  for (auto _ : state) {
    state.PauseTiming();
    VoxelMap current;
    change::Differencer differencer(grown, std::nullopt);
    for (std::size_t i = 0; i < r.frames.size(); ++i) {
      current.insert(r.frames[i], r.poses[i]);
      state.ResumeTiming();
      benchmark::DoNotOptimize(change::regions(differencer.update(current).appeared, current).size());
      state.PauseTiming();
    }
    state.ResumeTiming();
  }
  state.counters["ms_a_frame"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(r.frames.size()) / 1e3,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// A flat of 90 m2: dilation of the reference, and difference of everything.
VoxelMap flat(std::uint64_t seed) {
  VoxelMap map;
  RandomStream random(seed, "flat");
  for (int y = 0; y < 180; ++y) {
    for (int x = 0; x < 200; ++x) {
      const bool furniture = (x / 20 + y / 18) % 5 == 0;
      for (int z = -1; z < 40; ++z) {
        const bool occupied = z < 0 || (furniture && z < 10) || random.below(2000) == 0;
        map.set({x, y, z}, occupied ? Occupancy::kOccupied : Occupancy::kFree);
      }
    }
  }
  return map;
}

void difference_of_a_flat(benchmark::State& state) {
  const VoxelMap reference = dilated(flat(1), 1), current = flat(2);
  for (auto _ : state) {
    state.PauseTiming();
    change::Differencer differencer(reference, std::nullopt);
    state.ResumeTiming();
    benchmark::DoNotOptimize(differencer.update(current).appeared.size());
  }
}

BENCHMARK_CAPTURE(insert_ours, blocks, "blocks")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(insert_ours, octomap, "octomap")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(insert_octomap, normal, false)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(insert_octomap, discretized, true)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(difference_by_frame)->Unit(benchmark::kMillisecond);
BENCHMARK(difference_of_a_flat)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
