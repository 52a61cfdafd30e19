#include "mission/mapping_run.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace amiss::mission {

namespace {

constexpr double kGoalTolerance = 0.4;  // m
constexpr double kFirstLook = 2.0;      // s of standing, so that SLAM has a scan
constexpr double kAreaEdge = 60.0;      // m, of the square that the first half can map
constexpr double kFailedRadius = 0.5;   // m round a goal that failed, where no other goal is tried
constexpr double kOutsideRadius = 1.5;  // m, the same round a goal out of doors
constexpr double kEnclosed = 0.5;       // part of the beams that return indoors, at least

FloorGrid empty_area() {
  const int cells = static_cast<int>(kAreaEdge / 0.05);
  return {0.05, Eigen::Vector2d::Constant(-kAreaEdge / 2.0), cells, cells};
}

bool never() { return false; }

/// The first half.
class Exploration {
 public:
  Exploration(Perception& perception, localize::LaserMapper& mapper, const Params& params, RandomStream random)
      : perception_(perception),
        mapper_(mapper),
        params_(params),
        navigator_(perception, mapper.grid(), {}, params.navigation, random) {}

  /// The number of goals driven to.
  int run() {
    int goals = 0;
    if (navigator_.turn(2.0 * std::numbers::pi).outcome == DriveOutcome::kEnded) return goals;
    while (goals < params_.mapping_run.max_goals) {
      navigator_.set_floor(mapper_.grid());
      const auto ways = navigator_.ways_from_here();
      const auto found = view::frontiers(navigator_.drive_map().grid(), ways.field(), params_.frontier);
      const auto next = std::find_if(found.begin(), found.end(), [&](const auto& f) { return !failed(f.goal); });
      if (next == found.end()) return goals;
      ++goals;
      const Pose2<Map, Base> here = perception_.pose().T_map_base;
      const DriveReport report =
          navigator_.drive_to(next->goal, kGoalTolerance, [&] { return outdoors() || map_grew(next->middle_m); });
      if (report.outcome == DriveOutcome::kEnded) return goals;
      if (outdoors()) {
        perception_.sinks().log(perception_.now(), "turned back where the building ends");
        outside_.push_back(next->goal.position());
        if (navigator_.drive_to(here, kGoalTolerance, never).outcome == DriveOutcome::kEnded) return goals;
      } else if (report.outcome != DriveOutcome::kPointless) {
        tried_.push_back(next->goal.position());
      }
    }
    return goals;
  }

 private:
  [[nodiscard]] bool failed(const Pose2<Map, Base>& goal) const {
    const auto near = [&](const std::vector<Eigen::Vector2d>& places, double radius_m) {
      return std::any_of(places.begin(), places.end(),
                         [&](const auto& p) { return (p - goal.position()).norm() < radius_m; });
    };
    return near(tried_, kFailedRadius) || near(outside_, kOutsideRadius);
  }
  /// Where little surrounds the robot the flat ends, and SLAM has nothing to hold on to.
  [[nodiscard]] bool outdoors() const {
    return perception_.returned_part() < kEnclosed || !perception_.pose().converged;
  }
  /// Takes over what SLAM mapped since; true when there is nothing unknown left round the frontier.
  bool map_grew(const Eigen::Vector2d& frontier) {
    const FloorGrid& grid = mapper_.grid();
    navigator_.set_floor(grid);
    const Cell middle = grid.cell_at(frontier);
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dx = -2; dx <= 2; ++dx) {
        if (grid.at(Cell{middle.x + dx, middle.y + dy}) == Occupancy::kUnknown) return false;
      }
    }
    return true;
  }

  Perception& perception_;
  localize::LaserMapper& mapper_;
  const Params& params_;
  Navigator navigator_;
  std::vector<Eigen::Vector2d> tried_, outside_;  // goals that failed, that lie out of doors
};

/// The second half.
class Survey {
 public:
  Survey(Perception& perception, const FloorGrid& floor, const Params& params, std::uint64_t seed)
      : perception_(perception),
        floor_(floor),
        params_(params),
        triangle_(params.triangle),
        random_(seed, "map/triangles"),
        navigator_(perception, floor, {}, params.navigation, RandomStream(seed, "map/paths")) {
    triangle_.coverage_goal = params.mapping_run.coverage_goal;
    triangle_.min_gain_m2 = 0.1;
    triangle_.max_triangles = params.mapping_run.max_goals;
  }

  /// The number of triangles visited; coverage_ tells how much of the floor was seen.
  int run() {
    int visited = 0;
    for (int round = 0; round < 3 && visited < params_.mapping_run.max_goals; ++round) {
      auto open = view::cover_with_triangles(floor_, navigator_.ways_from_here().field(),
                                             perception_.obstacles().seen_floor(), triangle_, random_);
      coverage = open.coverage;
      if (open.triangles.empty()) break;
      while (!open.triangles.empty()) {
        const std::size_t next = nearest(open.triangles);
        const view::ViewTriangle triangle = open.triangles[next];
        open.triangles.erase(open.triangles.begin() + static_cast<std::ptrdiff_t>(next));
        if (view::covered_fraction(triangle, perception_.obstacles().seen_floor()) > kWellCovered) continue;
        ++visited;
        if (!visit(triangle.T_map_base)) return visited;
      }
    }
    return visited;
  }

  double coverage = 0.0;

 private:
  static constexpr double kWellCovered = 0.98;

  [[nodiscard]] std::size_t nearest(const std::vector<view::ViewTriangle>& triangles) {
    const motion::PathLengths ways = navigator_.ways_from_here();
    const auto way = [&](const view::ViewTriangle& t) { return ways.near(t.T_map_base.position(), kGoalTolerance); };
    const auto least = std::min_element(triangles.begin(), triangles.end(),
                                        [&](const auto& a, const auto& b) { return way(a) < way(b); });
    return static_cast<std::size_t>(least - triangles.begin());
  }

  /// Drives there and sweeps the head; false when the run ended.
  bool visit(const Pose2<Map, Base>& pose) {
    const DriveReport report = navigator_.drive_to(pose, kGoalTolerance, never);
    if (report.outcome == DriveOutcome::kEnded) return false;
    if (report.outcome != DriveOutcome::kArrived) return true;
    const MappingRunParams& p = params_.mapping_run;
    const std::array<robot::HeadState, 5> sweep{{{0.0, p.sweep_low_tilt_rad},
                                                 {p.sweep_pan_rad, p.sweep_low_tilt_rad},
                                                 {p.sweep_pan_rad, p.sweep_high_tilt_rad},
                                                 {-p.sweep_pan_rad, p.sweep_high_tilt_rad},
                                                 {-p.sweep_pan_rad, p.sweep_low_tilt_rad}}};
    return std::all_of(sweep.begin(), sweep.end(), [&](const robot::HeadState& head) { return look(head); });
  }
  bool look(const robot::HeadState& head) {
    const robot::HeadState from = perception_.head();
    const double way = std::max(std::abs(head.pan_rad - from.pan_rad), std::abs(head.tilt_rad - from.tilt_rad));
    return navigator_.stand(way / perception_.model().limits.head_rad_s + 0.4, head);
  }

  Perception& perception_;
  const FloorGrid& floor_;
  const Params& params_;
  view::TriangleParams triangle_;
  RandomStream random_;
  Navigator navigator_;
};

}  // namespace

MappingReport make_reference(robot::Robot& robot, const Params& params, std::uint64_t seed, const Sinks& sinks) {
  localize::LaserMapper mapper(params.laser_mapper);
  Perception perception(robot, std::make_unique<MapperTracker>(mapper), empty_area(), params.voxels, params.perception,
                        sinks);
  MappingReport report;
  const Stamp begin_until = Stamp{} + duration_of(kFirstLook);
  while (perception.now() < begin_until) perception.step({});
  report.frontiers = Exploration(perception, mapper, params, RandomStream(seed, "map/exploration")).run();

  report.reference.floor = mapper.cleaned_grid();
  localize::Localizer localizer(report.reference.floor, perception.pose().T_map_base, {0.05, radians(2.0)},
                                params.localizer, RandomStream(seed, "map/localizer"));
  perception.restart(std::make_unique<LocalizerTracker>(std::move(localizer)), report.reference.floor);
  Survey survey(perception, report.reference.floor, params, seed);
  report.triangles = survey.run();
  report.coverage = survey.coverage;

  report.reference.mapped = mapping::without_speckles(perception.voxels(), params.mapping_run.speckle_voxels);
  report.reference.reference = mapping::dilated(report.reference.mapped, params.mapping_run.dilation_voxels);
  report.complete = !sinks.stop() && !perception.out_of_time();
  report.distance_m = perception.distance_m();
  report.ended = perception.now();
  return report;
}

}  // namespace amiss::mission
