// What an examination and a whole frame cost to segment.
#include <benchmark/benchmark.h>

#include "segment/scene.hpp"
#include "segment/segment.hpp"

namespace {

using namespace amiss;

testing::View the_view() {
  return testing::look({testing::box_at(1.0, 0.1, {0.3, 0.2, 0.25}, 0.4, {200, 30, 30}, 1),
                        testing::ellipsoid_at(1.4, -0.3, {0.2, 0.2, 0.2}, 0.0, {30, 30, 200}, 2),
                        testing::box_at(2.6, 0.0, {0.1, 5.0, 2.5}, 0.0, {230, 230, 230}, 3)},
                       -0.75, 1);
}

void segment_region(benchmark::State& state) {
  const testing::View view = the_view();
  for (auto _ : state) {
    benchmark::DoNotOptimize(segment::segment_region(view.frame, view.T_map_camera, {{1.0, 0.1}, 0.2, 0.0, 0.25}, {}));
  }
}
BENCHMARK(segment_region)->Unit(benchmark::kMillisecond);

void segment_frame(benchmark::State& state) {
  const testing::View view = the_view();
  for (auto _ : state) benchmark::DoNotOptimize(segment::segment_frame(view.frame, view.T_map_camera, {}));
}
BENCHMARK(segment_frame)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
