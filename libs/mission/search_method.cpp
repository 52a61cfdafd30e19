#include "mission/search_method.hpp"

#include <algorithm>
#include <numbers>

#include "motion/path_lengths.hpp"

namespace amiss::mission {

namespace {

constexpr double kViewTolerance = 0.3;  // m that the place of a view triangle may be moved by
constexpr double kRecoveryStep = 0.2;   // s between two looks at whether a trouble is over

}  // namespace

std::string_view to_string(SearchEnd end) {
  switch (end) {
    case SearchEnd::kExplored:
      return "explored";
    case SearchEnd::kStopped:
      return "stopped";
    case SearchEnd::kTimeLimit:
      return "time_limit";
    case SearchEnd::kGaveUp:
      return "gave_up";
    case SearchEnd::kLost:
      return "lost";
    case SearchEnd::kSensorLost:
      return "sensor_lost";
  }
  return "";
}

localize::Localizer search_localizer(const FloorGrid& floor, const localize::LocalizerParams& params,
                                     std::uint64_t seed, const Pose2<Map, Base>& start) {
  return {floor, start, {}, params, RandomStream(seed, "search/localizer")};
}

void add_objects(knowledge::KnowledgeBase& knowledge, int region, Stamp frame,
                 const std::vector<segment::Segment>& segments) {
  for (const segment::Segment& s : segments) {
    knowledge.add_object({0, region, frame, s.centre_map, s.size_m, s.points});
  }
}

SearchMethod::SearchMethod(robot::Robot& robot, const Reference& reference, knowledge::KnowledgeBase& knowledge,
                           const plan::Domain& domain, const Params& params, std::uint64_t seed, bool keep_searching,
                           const Sinks& sinks)
    : reference_(reference),
      knowledge_(knowledge),
      params_(params),
      keep_searching_(keep_searching),
      sinks_(sinks),
      static_obstacles_(reference.floor, params.voxels.resolution_m),
      perception_(robot, std::make_unique<LocalizerTracker>(search_localizer(reference.floor, params.localizer, seed)),
                  reference.floor, params.voxels, params.perception, sinks),
      navigator_(perception_, reference.floor, {&static_obstacles_.obstacles()}, params.navigation,
                 RandomStream(seed, "search/paths")),
      domain_(domain),
      triangles_random_(seed, "search/triangles") {
  static_obstacles_.update(reference.mapped);
  navigator_.heed_trouble();
}

SearchReport SearchMethod::run() {
  Progress progress = Progress::kReplan;
  if (navigator_.turn(2.0 * std::numbers::pi).outcome == DriveOutcome::kEnded) progress = Progress::kEnded;
  report_.end = SearchEnd::kGaveUp;
  while (progress != Progress::kEnded && report_.plans < params_.search.max_replans) {
    progress = recover();
    if (progress == Progress::kEnded) break;
    take_stock();
    std::vector<Visit> visits = open_visits();
    if (visits.empty()) {
      if (!add_view_triangles()) {
        report_.end = SearchEnd::kExplored;
        break;
      }
      visits = open_visits();
    }
    const auto plan = make_plan(visits);
    progress = plan ? carry_out(*plan) : wait();
  }
  if (progress == Progress::kEnded) report_.end = ended_because();
  report_.coverage = coverage();
  report_.distance_m = perception_.distance_m();
  report_.ended = perception_.now();
  return report_;
}

SearchEnd SearchMethod::ended_because() const {
  if (given_in_to_) return given_in_to_->complaint == Complaint::kLost ? SearchEnd::kLost : SearchEnd::kSensorLost;
  return perception_.out_of_time() ? SearchEnd::kTimeLimit : SearchEnd::kStopped;
}

SearchMethod::Progress SearchMethod::recover() {
  if (is_well()) return Progress::kReplan;
  const HealthParams& health = params_.perception.health;
  std::string told;
  while (!is_well()) {
    const auto trouble = perception_.trouble();
    const bool lost = trouble && trouble->complaint == Complaint::kLost;
    if (trouble && to_string(*trouble) != told) {
      told = to_string(*trouble);
      sinks_.log(perception_.now(), "waits: " + told);
    }
    if (trouble &&
        perception_.now() - trouble->since > duration_of(lost ? health.lost_patience_s : health.patience_s)) {
      given_in_to_ = trouble;
      report_.why = told;
      sinks_.log(perception_.now(), "gives in: " + told);
      return Progress::kEnded;
    }
    const robot::HeadState gaze{0.0, params_.navigation.navigator.head_tilt_rad};
    if (!(lost ? navigator_.look_round(kRecoveryStep) : navigator_.stand(kRecoveryStep, gaze))) return Progress::kEnded;
  }
  if (!told.empty()) sinks_.log(perception_.now(), "goes on");
  recovered();
  return Progress::kReplan;
}

SearchMethod::Progress SearchMethod::carry_out(const VisitPlan& plan) {
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const PlannedStep& step = plan.steps[i];
    sinks_.acting({perception_.now(), i});
    const Progress progress = step.action == PlannedStep::Action::kGoto ? go_to(step.visit) : arrived(step.visit);
    if (progress != Progress::kDone) return progress;
  }
  return Progress::kReplan;
}

SearchMethod::Progress SearchMethod::go_to(const Visit& visit) {
  bool changed = false;
  const Stamp begin = perception_.now();
  const double tolerance = visit.kind == Visit::Kind::kExplore ? kViewTolerance : 0.0;
  const DriveReport report = navigator_.drive_to(visit.T_map_base, tolerance, [&] {
    changed = replan_due();
    return changed || is_pointless(visit);
  });
  report_.driving += perception_.now() - begin;
  switch (report.outcome) {
    case DriveOutcome::kArrived:
      return Progress::kDone;
    case DriveOutcome::kPointless:
      return Progress::kReplan;
    case DriveOutcome::kEnded:
      return Progress::kEnded;
    case DriveOutcome::kFailed:
      ++report_.navigation_errors[report.error];
      // In trouble the goal is not to blame.
      return is_well() ? failed(visit, report.why) : recover();
  }
  return Progress::kEnded;
}

SearchMethod::Progress SearchMethod::failed(const Visit& visit, const std::string& why) {
  ++report_.failed_actions;
  sinks_.log(perception_.now(), (visit.kind == Visit::Kind::kExplore ? "view triangle " : "viewpoint of region ") +
                                    std::to_string(visit.id) + " was not reached: " + why);
  if (visit.kind == Visit::Kind::kExplore) {
    knowledge_.mark_dropped(visit.id);
    open_views_.erase(visit.id);
  }
  return Progress::kReplan;
}

SearchMethod::Progress SearchMethod::look(const robot::HeadState& gaze) {
  const double turning = std::max(std::abs(gaze.pan_rad - perception_.head().pan_rad),
                                  std::abs(gaze.tilt_rad - perception_.head().tilt_rad));
  const Duration settled = duration_of(turning / perception_.model().limits.head_rad_s + 0.1);
  const Stamp from = perception_.now() + settled;
  if (!navigator_.stand(seconds(settled) + params_.search.settle_s, gaze)) return Progress::kEnded;
  while (!perception_.last_frame() || perception_.last_frame()->captured.frame.stamp < from) {
    if (perception_.trouble()) return recover();
    if (!navigator_.stand(kRecoveryStep, gaze)) return Progress::kEnded;
  }
  return perception_.trouble() ? recover() : Progress::kDone;
}

bool SearchMethod::segment(int region, const robot::HeadState& gaze, double cost_s, const Segmenter& segmenter) {
  const LocatedFrame frame = perception_.last_frame().value();
  sinks_.segmenting({&frame.captured.frame, frame.T_map_camera});
  const double wall_before_ms = sinks_.wall_clock_ms();
  const segment::Segmentation result = segmenter(frame);
  const double wall_ms = sinks_.wall_clock_ms() - wall_before_ms;
  ++report_.segmentation_actions;
  const Stamp begin = perception_.now();
  const bool goes_on = cost_s <= 0.0 || navigator_.stand(cost_s, gaze);
  const Duration cost = perception_.now() - begin;
  report_.segmentation_cost += cost;
  if (!goes_on) return false;
  if (region > 0) knowledge_.mark_examined(region, perception_.now());
  add_objects(knowledge_, region, frame.captured.frame.stamp, result.segments);
  sinks_.examined(
      {region, perception_.now(), &frame.captured.frame, frame.T_map_camera, &result.segments, wall_ms, cost});
  return true;
}

void SearchMethod::remember(std::vector<view::ViewTriangle> triangles) {
  std::vector<knowledge::View> views;
  for (const view::ViewTriangle& t : triangles) {
    views.push_back({0, t.T_map_base, t.angle_rad, t.height_m, false, std::nullopt});
  }
  const std::vector<int> ids = knowledge_.add_views(views);
  for (std::size_t i = 0; i < ids.size(); ++i) open_views_.emplace(ids[i], std::move(triangles[i]));
  report_.view_triangles += static_cast<int>(ids.size());
}

std::vector<view::ViewTriangle> SearchMethod::sample(const FloorGrid& covered, const view::TriangleParams& params) {
  const motion::PathLengths ways = navigator_.ways_from_here();
  auto cover =
      view::cover_with_triangles(navigator_.drive_map().grid(), ways.field(), covered, params, triangles_random_);
  return std::move(cover.triangles);
}

std::vector<Visit> SearchMethod::open_view_visits(const motion::PathLengths& ways,
                                                  const std::function<bool(const view::ViewTriangle&)>& wanted) {
  std::vector<Visit> visits;
  for (auto view = open_views_.begin(); view != open_views_.end();) {
    const bool reachable =
        ways.near(view->second.T_map_base.position(), kWayTolerance) < motion::PathLengths::kUnreachable;
    if (reachable && wanted(view->second)) {
      visits.push_back({Visit::Kind::kExplore, view->first, view->second.T_map_base});
      ++view;
    } else {
      knowledge_.mark_dropped(view->first);
      view = open_views_.erase(view);
    }
  }
  return visits;
}

SearchMethod::Progress SearchMethod::wait() {
  const robot::HeadState gaze{0.0, params_.navigation.navigator.head_tilt_rad};
  return navigator_.stand(params_.search.look_s, gaze) ? Progress::kReplan : Progress::kEnded;
}

std::optional<VisitPlan> SearchMethod::make_plan(const std::vector<Visit>& visits) {
  ++report_.plans;
  if (visits.empty()) return std::nullopt;
  std::vector<Eigen::Vector2d> places{perception_.pose().T_map_base.position()};
  for (const Visit& v : visits) places.push_back(v.T_map_base.position());
  const auto lengths = motion::way_matrix(navigator_.drive_map(), places, kWayTolerance);
  auto plan = plan_visits(domain_, visits, lengths);
  if (!plan) {
    sinks_.log(perception_.now(), "no plan: " + plan.why());
    return std::nullopt;
  }
  sinks_.planned({perception_.now(), report_.plans, plan->problem_pddl, plan::to_string(plan->plan), &plan->steps});
  return *plan;
}

void SearchMethod::report_progress() {
  int regions = 0, examined = 0;
  for (const knowledge::Region& r : knowledge_.now().regions) {
    if (r.withdrawn) continue;
    ++regions;
    if (r.examined) ++examined;
  }
  const std::size_t seen = perception_.obstacles().seen_cells();
  const double cell = params_.voxels.resolution_m * params_.voxels.resolution_m;
  sinks_.progress({perception_.now(), static_cast<double>(seen) * cell, regions, examined});
}

double SearchMethod::coverage() {
  const FloorGrid& seen = perception_.obstacles().seen_floor();
  if (reachable_cells_ == 0) {
    const motion::PathLengths ways(navigator_.drive_map(), perception_.pose().T_map_base.position());
    const auto field = ways.field();
    reachable_cells_ = static_cast<std::size_t>(
        std::count_if(field.begin(), field.end(), [](float way) { return way < motion::PathLengths::kUnreachable; }));
  }
  if (reachable_cells_ == 0) return 0.0;
  const motion::PathLengths ways = navigator_.ways_from_here();
  std::size_t known = 0;
  const FloorGrid& grid = navigator_.drive_map().grid();
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const bool reachable = ways.to(Cell{x, y}) < motion::PathLengths::kUnreachable;
      if (reachable && seen.at(grid.centre_of({x, y})) != Occupancy::kUnknown) ++known;
    }
  }
  return static_cast<double>(known) / static_cast<double>(reachable_cells_);
}

}  // namespace amiss::mission
