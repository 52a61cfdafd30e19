// What a scan costs in localization and in laser mapping, on a tour through a furnished flat.
#include <benchmark/benchmark.h>

#include "localize/flat.hpp"
#include "localize/laser_mapper.hpp"
#include "localize/localizer.hpp"

namespace {

using namespace amiss;

const testing::Drive& the_drive() {
  static const testing::Drive drive = testing::drive(testing::Flat::furnished(), testing::tour(), 1);
  return drive;
}

void report(benchmark::State& state, std::size_t scans) {
  state.counters["ms_per_scan"] =
      benchmark::Counter(static_cast<double>(scans) * 1e-3, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void localizer(benchmark::State& state) {
  const testing::Drive& drive = the_drive();
  const FloorGrid map = testing::Flat::furnished().grid();
  const Pose2<World, Base> first = drive.steps.front().truth;
  std::size_t scans = 0;
  for (auto _ : state) {
    localize::Localizer localizer(map, {first.x_m, first.y_m, first.yaw_rad}, {}, {}, RandomStream(1, "bench"));
    for (const auto& step : drive.steps) {
      benchmark::DoNotOptimize(
          localizer.update(step.odometry, step.has_scan ? &step.scan : nullptr, testing::laser_mount()));
      scans += step.has_scan ? 1 : 0;
    }
  }
  report(state, scans);
}
BENCHMARK(localizer)->Unit(benchmark::kMillisecond);

void laser_mapper(benchmark::State& state) {
  const testing::Drive& drive = the_drive();
  std::size_t scans = 0;
  for (auto _ : state) {
    localize::LaserMapper mapper{localize::LaserMapperParams{}};
    for (const auto& step : drive.steps) {
      if (!step.has_scan) continue;
      benchmark::DoNotOptimize(mapper.update(step.odometry, step.scan, testing::laser_mount()));
      ++scans;
    }
    benchmark::DoNotOptimize(mapper.cleaned_grid());
  }
  report(state, scans);
}
BENCHMARK(laser_mapper)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
