#include "view/view_triangle.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <queue>

#include "view/internal/triangle_view.hpp"

namespace amiss::view {
namespace {

constexpr std::array<Cell, 4> kSides{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// 1 for free floor that is connected through free floor with a place where the robot can be.
std::vector<std::uint8_t> target_floor(const FloorGrid& sight, std::span<const float> travel_m) {
  std::vector<std::uint8_t> target(sight.cells().size(), 0);
  std::vector<Cell> open;
  const auto add = [&](Cell c) {
    if (sight.at(c) != Occupancy::kFree || target[sight.index(c)] != 0) return;
    target[sight.index(c)] = 1;
    open.push_back(c);
  };
  for (int y = 0; y < sight.height(); ++y) {
    for (int x = 0; x < sight.width(); ++x) {
      if (std::isfinite(travel_m[sight.index({x, y})])) add({x, y});
    }
  }
  while (!open.empty()) {
    const Cell c = open.back();
    open.pop_back();
    for (const Cell side : kSides) add({c.x + side.x, c.y + side.y});
  }
  return target;
}

struct Sample {
  Pose2<Map, Base> T_map_base;
  std::vector<std::uint32_t> cells;  // of the target, inside the triangle and not hidden
};

ViewTriangle triangle_of(const FloorGrid& sight, const Pose2<Map, Base>& T_map_base, const TriangleParams& params,
                         internal::TriangleView& view) {
  ViewTriangle triangle{T_map_base, params.angle_rad, params.height_m, {}, 0.0};
  const auto width = static_cast<std::uint32_t>(sight.width());
  for (const std::uint32_t cell : view.from(T_map_base)) {
    const Cell c{static_cast<int>(cell % width), static_cast<int>(cell / width)};
    triangle.floor_m.push_back(sight.centre_of(c).cast<float>());
  }
  return triangle;
}

std::vector<Sample> sample_triangles(const FloorGrid& sight, std::span<const float> travel_m,
                                     const std::vector<std::uint8_t>& target, int count, internal::TriangleView& view,
                                     RandomStream& random) {
  std::vector<Cell> places;
  for (int y = 0; y < sight.height(); ++y) {
    for (int x = 0; x < sight.width(); ++x) {
      if (std::isfinite(travel_m[sight.index({x, y})])) places.push_back({x, y});
    }
  }
  std::vector<Sample> samples;
  if (places.empty()) return samples;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d place = sight.centre_of(places[random.below(places.size())]);
    Sample sample;
    sample.T_map_base = {place.x(), place.y(), wrap_angle(random.uniform(-std::numbers::pi, std::numbers::pi))};
    for (const std::uint32_t cell : view.from(sample.T_map_base)) {
      if (target[cell] != 0) sample.cells.push_back(cell);
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

struct Candidate {
  std::size_t gain = 0;
  std::size_t sample = 0;
  std::size_t round = 0;  // in which the gain was counted
  /// Is worse: less gain, the later sample of equal ones.
  bool operator<(const Candidate& other) const {
    return gain != other.gain ? gain < other.gain : sample > other.sample;
  }
};

/// Gains only shrink (submodularity), so a gain counted in an earlier round is an upper bound: only the candidate on
/// top is counted again.
class LazyCover {
 public:
  LazyCover(const std::vector<Sample>& samples, std::vector<std::uint8_t>& open) : samples_(samples), open_(open) {
    for (std::size_t i = 0; i < samples.size(); ++i) queue_.push({samples[i].cells.size(), i, 0});
  }

  Candidate best(std::size_t round) {
    while (!queue_.empty()) {
      Candidate top = queue_.top();
      queue_.pop();
      if (top.round == round) return top;
      const auto& cells = samples_[top.sample].cells;
      top.gain = static_cast<std::size_t>(
          std::count_if(cells.begin(), cells.end(), [&](std::uint32_t cell) { return open_[cell] != 0; }));
      top.round = round;
      ++evaluations_;
      queue_.push(top);
    }
    return {};
  }

  void take(const Candidate& candidate) {
    for (const std::uint32_t cell : samples_[candidate.sample].cells) open_[cell] = 0;
  }

  [[nodiscard]] int evaluations() const { return evaluations_; }

 private:
  const std::vector<Sample>& samples_;
  std::vector<std::uint8_t>& open_;
  std::priority_queue<Candidate> queue_;
  int evaluations_ = 0;
};

}  // namespace

void describe(ParamTable& table, TriangleParams& p) {
  table.integer("view.samples", p.samples, 1, 1000000, "random view triangles to choose from");
  table.number("view.angle", p.angle_rad, "deg", 5.0, 170.0, "field of view (tr_angle)");
  table.number("view.height", p.height_m, "m", 0.2, 20.0, "viewing distance (tr_height)");
  table.number("view.coverage_goal", p.coverage_goal, "", 0.0, 1.0,
               "part of the floor not covered yet that one set of triangles covers");
  table.number("view.min_gain", p.min_gain_m2, "m2", 0.0, 100.0, "floor that a triangle must add");
  table.integer("view.max_triangles", p.max_triangles, 1, 10000, "triangles at most");
  table.number("view.drop_above", p.drop_above, "", 0.0, 1.0, "triangles with a greater part seen already are dropped");
}

TriangleCover cover_with_triangles(const FloorGrid& sight, std::span<const float> travel_m, const FloorGrid& covered,
                                   const TriangleParams& params, RandomStream& random) {
  assert(travel_m.size() == sight.cells().size());
  const std::vector<std::uint8_t> target = target_floor(sight, travel_m);
  internal::TriangleView view(sight, params.angle_rad, params.height_m);
  const std::vector<Sample> samples = sample_triangles(sight, travel_m, target, params.samples, view, random);
  std::vector<std::uint8_t> open = target;
  for (int y = 0; y < sight.height(); ++y) {
    for (int x = 0; x < sight.width(); ++x) {
      if (covered.at(sight.centre_of({x, y})) != Occupancy::kUnknown) open[sight.index({x, y})] = 0;
    }
  }
  const double cell_m2 = sight.resolution_m() * sight.resolution_m();
  const auto all = static_cast<double>(std::count(target.begin(), target.end(), 1));
  const auto wanted = static_cast<double>(std::count(open.begin(), open.end(), 1));
  double left = wanted;
  TriangleCover cover;
  LazyCover lazy(samples, open);
  while (static_cast<int>(cover.triangles.size()) < params.max_triangles &&
         wanted - left < params.coverage_goal * wanted) {
    const Candidate best = lazy.best(cover.triangles.size() + 1);
    const double gain_m2 = static_cast<double>(best.gain) * cell_m2;
    if (best.gain == 0 || gain_m2 < params.min_gain_m2) break;
    lazy.take(best);
    left -= static_cast<double>(best.gain);
    cover.triangles.push_back(triangle_of(sight, samples[best.sample].T_map_base, params, view));
    cover.triangles.back().gain_m2 = gain_m2;
  }
  cover.target_m2 = all * cell_m2;
  cover.coverage = all > 0.0 ? (all - left) / all : 1.0;
  cover.evaluations = lazy.evaluations();
  return cover;
}

ViewTriangle view_triangle(const FloorGrid& sight, const Pose2<Map, Base>& T_map_base, const TriangleParams& params) {
  internal::TriangleView view(sight, params.angle_rad, params.height_m);
  return triangle_of(sight, T_map_base, params, view);
}

double covered_fraction(const ViewTriangle& triangle, const FloorGrid& seen) {
  if (triangle.floor_m.empty()) return 1.0;
  const auto known = std::count_if(triangle.floor_m.begin(), triangle.floor_m.end(), [&](const Eigen::Vector2f& p) {
    return seen.at(Eigen::Vector2d(p.cast<double>())) != Occupancy::kUnknown;
  });
  return static_cast<double>(known) / static_cast<double>(triangle.floor_m.size());
}

}  // namespace amiss::view
