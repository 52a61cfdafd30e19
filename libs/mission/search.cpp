#include "mission/search.hpp"

#include <algorithm>
#include <numbers>

#include "motion/path_lengths.hpp"

namespace amiss::mission {

namespace {

constexpr double kViewTolerance = 0.3;  // m that the place of a view triangle may be moved by
constexpr double kWayTolerance = 0.4;   // m round a place, for way lengths

Stamp later(Stamp now, double seconds_s) { return now + duration_of(seconds_s); }

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
  }
  return "";
}

Search::Search(robot::Robot& robot, const Reference& reference, knowledge::KnowledgeBase& knowledge,
               const plan::Domain& domain, const Params& params, std::uint64_t seed, bool keep_searching,
               const Sinks& sinks)
    : reference_(reference),
      knowledge_(knowledge),
      domain_(domain),
      params_(params),
      keep_searching_(keep_searching),
      sinks_(sinks),
      triangles_random_(seed, "search/triangles"),
      static_obstacles_(reference.floor, params.voxels.resolution_m),
      perception_(robot,
                  std::make_unique<LocalizerTracker>(localize::Localizer(reference.floor, {}, {}, params.localizer,
                                                                         RandomStream(seed, "search/localizer"))),
                  reference.floor, params.voxels, params.perception, sinks),
      navigator_(perception_, reference.floor, {&static_obstacles_.obstacles()}, params.navigation,
                 RandomStream(seed, "search/paths")),
      differencer_(reference.reference, reference.floor, params.difference),
      head_(view::head_of(robot.model())) {
  static_obstacles_.update(reference.mapped);
}

SearchReport Search::run() {
  Progress progress = Progress::kReplan;
  if (navigator_.turn(2.0 * std::numbers::pi).outcome == DriveOutcome::kEnded) progress = Progress::kEnded;
  report_.end = SearchEnd::kGaveUp;
  while (progress != Progress::kEnded && report_.plans < params_.search.max_replans) {
    compare();
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
  if (progress == Progress::kEnded) {
    report_.end = perception_.out_of_time() ? SearchEnd::kTimeLimit : SearchEnd::kStopped;
  }
  report_.coverage = coverage();
  report_.distance_m = perception_.distance_m();
  report_.ended = perception_.now();
  return report_;
}

Search::Progress Search::carry_out(const VisitPlan& plan) {
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const PlannedStep& step = plan.steps[i];
    Progress progress = Progress::kDone;
    sinks_.acting({perception_.now(), i});
    switch (step.action) {
      case PlannedStep::Action::kGoto:
        progress = go_to(step.visit);
        break;
      case PlannedStep::Action::kExplore:
        progress = explore(step.visit);
        break;
      case PlannedStep::Action::kExamine:
        progress = examine(step.visit);
        break;
    }
    if (progress != Progress::kDone) return progress;
  }
  return Progress::kReplan;
}

Search::Progress Search::go_to(const Visit& visit) {
  bool changed = false;
  const Stamp begin = perception_.now();
  const double tolerance = visit.kind == Visit::Kind::kExplore ? kViewTolerance : 0.0;
  const DriveReport report = navigator_.drive_to(visit.T_map_base, tolerance, [&] {
    changed = compare_due();
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
      return failed(visit, report.why);
  }
  return Progress::kEnded;
}

Search::Progress Search::explore(const Visit& visit) {
  if (!navigator_.stand(params_.search.look_s, {0.0, params_.navigation.navigator.head_tilt_rad})) {
    return Progress::kEnded;
  }
  knowledge_.mark_visited(visit.id, perception_.now());
  open_views_.erase(visit.id);
  return compare() ? Progress::kReplan : Progress::kDone;
}

Search::Progress Search::examine(const Visit& visit) {
  const Stamp begin = perception_.now();
  const robot::HeadState gaze = gaze_.at(visit.id);
  const double turning = std::max(std::abs(gaze.pan_rad - perception_.head().pan_rad),
                                  std::abs(gaze.tilt_rad - perception_.head().tilt_rad));
  const Stamp settled = later(begin, turning / perception_.model().limits.head_rad_s + 0.1);
  if (!navigator_.stand(seconds(settled - begin) + params_.search.settle_s, gaze)) return Progress::kEnded;
  compare();
  const knowledge::Region region = knowledge_.now().regions.at(static_cast<std::size_t>(visit.id - 1));
  if (region.withdrawn || region.examined) return Progress::kReplan;

  const LocatedFrame frame = perception_.last_frame().value();
  const segment::Cylinder crop{region.cylinder.centre_map, region.cylinder.radius_m, region.cylinder.z_low_m,
                               region.cylinder.z_high_m};
  const auto result = segment::segment_region(frame.captured.frame, frame.T_map_camera, crop, params_.segment);
  ++report_.segmentation_actions;
  if (params_.search.segment_region_s > 0.0 && !navigator_.stand(params_.search.segment_region_s, gaze)) {
    return Progress::kEnded;
  }
  knowledge_.mark_examined(visit.id, perception_.now());
  for (const segment::Segment& s : result.segments) {
    knowledge_.add_object({0, visit.id, frame.captured.frame.stamp, s.centre_map, s.size_m, s.points});
  }
  sinks_.examined({visit.id, perception_.now(), &frame.captured.frame, frame.T_map_camera, &result.segments});
  report_.segmenting += perception_.now() - begin;
  report_progress();
  return Progress::kReplan;
}

Search::Progress Search::failed(const Visit& visit, const std::string& why) {
  ++report_.failed_actions;
  sinks_.log(perception_.now(), (visit.kind == Visit::Kind::kExplore ? "view triangle " : "viewpoint of region ") +
                                    std::to_string(visit.id) + " was not reached: " + why);
  if (visit.kind == Visit::Kind::kExplore) {
    knowledge_.mark_dropped(visit.id);
    open_views_.erase(visit.id);
  } else {
    auto& tried = tried_viewpoints_[visit.id];
    tried.push_back(visit.T_map_base);
    if (static_cast<int>(tried.size()) >= params_.search.viewpoints) given_up_.insert(visit.id);
  }
  return Progress::kReplan;
}

bool Search::compare() {
  const double before = sinks_.wall_clock_ms();
  const change::Difference& difference = differencer_.update(perception_.voxels());
  const auto regions = change::regions(difference.appeared, perception_.voxels(), params_.region);
  sinks_.compared({perception_.now(), sinks_.wall_clock_ms() - before, &difference, &perception_.voxels()});
  std::vector<knowledge::Sighting> sightings;
  for (const change::Region& r : regions) {
    const Eigen::Vector3d middle(r.centre_m.x(), r.centre_m.y(), 0.5 * (r.z_low_m + r.z_high_m));
    sightings.push_back({middle, {r.centre_m, r.radius_m, r.z_low_m, r.z_high_m}, static_cast<int>(r.voxels.size())});
  }
  // The difference speaks of the whole map: a region that is not in it was looked at again and is gone.
  const auto changes = knowledge_.merge(
      sightings, [](const knowledge::Region&) { return true; }, perception_.now());
  next_comparison_ = later(perception_.now(), params_.search.compare_s);
  report_progress();
  return std::any_of(changes.begin(), changes.end(),
                     [](const knowledge::RegionChange& c) { return c.change != knowledge::Change::kGrown; });
}

bool Search::compare_due() { return perception_.now() >= next_comparison_ && compare(); }

Search::Progress Search::wait() {
  const robot::HeadState gaze{0.0, params_.navigation.navigator.head_tilt_rad};
  return navigator_.stand(params_.search.look_s, gaze) ? Progress::kReplan : Progress::kEnded;
}

std::optional<VisitPlan> Search::make_plan(const std::vector<Visit>& visits) {
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

void Search::report_progress() {
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

}  // namespace amiss::mission
