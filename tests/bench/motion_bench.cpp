// What view triangles, viewpoints, frontiers, drive maps, ways, paths, tours and a step of the follower cost in a flat
// of 90 m2 at 5 cm.
#include <benchmark/benchmark.h>

#include <cmath>

#include "motion/drive_sim.hpp"
#include "motion/path_lengths.hpp"
#include "motion/path_planner.hpp"
#include "motion/test_flat.hpp"
#include "motion/tour.hpp"
#include "view/frontier.hpp"
#include "view/test_head.hpp"
#include "view/view_pose.hpp"
#include "view/view_triangle.hpp"

namespace {

using namespace amiss;

const motion::DriveMap& flat() {
  static const motion::DriveMap map(test_flat(), {});
  return map;
}

std::vector<Eigen::Vector2d> places(std::size_t n) {
  RandomStream random(1, "places");
  std::vector<Eigen::Vector2d> found;
  while (found.size() < n) {
    const double x = random.uniform(0, 12);
    const Eigen::Vector2d p(x, random.uniform(0, 7.5));
    if (flat().passable(flat().grid().cell_at(p))) found.push_back(p);
  }
  return found;
}

void triangle_cover(benchmark::State& state) {
  const motion::PathLengths lengths(flat(), {4.0, 4.0});
  for (auto _ : state) {
    RandomStream random(1, "cover");
    benchmark::DoNotOptimize(view::cover_with_triangles(flat().grid(), lengths.field(), {}, {}, random));
  }
}
BENCHMARK(triangle_cover)->Unit(benchmark::kMillisecond);

void view_poses(benchmark::State& state) {
  const motion::PathLengths lengths(flat(), {4.0, 4.0});
  const view::Head head = view::test_head();
  const view::SightTest clear = [](const Eigen::Vector3d&, const Eigen::Vector3d&) { return true; };
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        view::view_poses({{1.0, 4.0, 0.05}, 0.08, 0.1}, flat().grid(), lengths.field(), clear, head, {}));
  }
}
BENCHMARK(view_poses)->Unit(benchmark::kMicrosecond);

void frontiers(benchmark::State& state) {
  FloorGrid grid = test_flat();
  fill_rect(grid, 8.0, 0.0, 12.0, 7.0, Occupancy::kUnknown);
  const motion::PathLengths lengths(motion::DriveMap(grid, {}), {4.0, 4.0});
  for (auto _ : state) benchmark::DoNotOptimize(view::frontiers(grid, lengths.field(), {}));
}
BENCHMARK(frontiers)->Unit(benchmark::kMicrosecond);

void drive_map_update(benchmark::State& state) {
  motion::DriveMap map(test_flat(), {});
  const FloorGrid layer = test_flat();
  const std::vector<const FloorGrid*> layers{&layer, &layer};
  const auto moving = places(64);
  std::size_t i = 0;
  for (auto _ : state) {
    const Eigen::Vector2d at = moving[i++ % moving.size()];
    benchmark::DoNotOptimize(map.update(layers, std::vector<Eigen::Vector2d>{at, at + Eigen::Vector2d(0.2, 0.1)}));
  }
}
BENCHMARK(drive_map_update)->Unit(benchmark::kMicrosecond);

void path_lengths(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(motion::PathLengths(flat(), {4.0, 4.0}));
}
BENCHMARK(path_lengths)->Unit(benchmark::kMicrosecond);

void plan_paths(benchmark::State& state) {
  motion::PlannerParams params;
  params.iterations = static_cast<int>(state.range(0));
  const auto goals = places(64);
  std::size_t i = 0;
  double cost_m = 0.0, sampled = 0.0, count = 0.0;
  for (auto _ : state) {
    RandomStream random(i, "plan");
    const Eigen::Vector2d a = goals[i % 64], b = goals[(i + 17) % 64];
    ++i;
    const auto planned = motion::plan_path(flat(), {a.x(), a.y(), 0}, {b.x(), b.y(), 0}, params, random);
    if (!planned) continue;
    cost_m += planned->cost_m;
    sampled += planned->sampled ? 1.0 : 0.0;
    count += 1.0;
  }
  state.counters["cost_m"] = cost_m / count;
  state.counters["sampled"] = sampled / count;
}
BENCHMARK(plan_paths)->Arg(0)->Arg(100)->Arg(300)->Arg(1000)->Iterations(640)->Unit(benchmark::kMicrosecond);

void tour_of_30(benchmark::State& state) {
  const auto lengths = motion::way_matrix(flat(), places(30));
  for (auto _ : state) benchmark::DoNotOptimize(motion::shortest_tour(lengths, 30));
}
BENCHMARK(tour_of_30)->Unit(benchmark::kMicrosecond);

void follower_step(benchmark::State& state) {
  motion::Follower follower({}, {});
  follower.start({{{1.5, 4.0}, {4.0, 4.0}, {6.0, 3.75}}, 0.0});
  motion::DriveSim sim;
  sim.pose = {1.5, 4.0, 0.0};
  const auto hits = sim.laser_base(flat().grid());
  for (auto _ : state) benchmark::DoNotOptimize(follower.step(sim.pose, flat(), hits, duration_of(0.02)));
}
BENCHMARK(follower_step)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
