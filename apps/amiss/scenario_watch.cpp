#include "scenario_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands.hpp"
#include "interrupt.hpp"

namespace amiss::app {

namespace {

constexpr double kRight_m = 0.15;      // a position that is no farther off counts as right
constexpr std::size_t kPathStep = 10;  // control periods between two places of the floor plan

/// The last time that the robot was carried away or its odometry jumped.
double last_disturbance_s(const std::vector<sim::Happening>& happened, const world::Script& script) {
  double last_s = 0.0;
  for (const sim::Happening& h : happened) {
    const bool disturbs = std::any_of(script.events.begin(), script.events.end(), [&](const world::Event& e) {
      const auto* fault = std::get_if<world::Fault>(&e.change);
      const bool is_jump = fault != nullptr && fault->kind == world::FaultKind::kJump;
      return (is_jump || std::holds_alternative<world::Kidnap>(e.change)) && to_string(e.change) == h.what;
    });
    if (disturbs) last_s = std::max(last_s, seconds(h.stamp));
  }
  return last_s;
}

}  // namespace

ScenarioWatch::ScenarioWatch(const scenario::Scenario& scenario, sim::Simulator& simulator, sim::ScriptedRobot& robot,
                             score::Referee& referee, const knowledge::KnowledgeBase& knowledge,
                             const Pose2<World, Map>& T_world_map)
    : scenario_(scenario),
      objects_(scenario::names_of(scenario.script)),
      simulator_(simulator),
      robot_(robot),
      referee_(referee),
      knowledge_(knowledge),
      T_world_map_(T_world_map) {}

mission::Sinks ScenarioWatch::sinks() {
  mission::Sinks sinks;
  sinks.step = [this](const mission::StepEvent& event) { on_step(event); };
  sinks.examined = [this](const mission::ExaminationEvent& event) { on_examined(event); };
  sinks.progress = [this](const mission::ProgressEvent&) { look_at_regions(); };
  sinks.planned = [this](const mission::PlanEvent& e) { note(e.stamp, fmt::format("plan {}", e.number)); };
  sinks.log = [this](Stamp stamp, const std::string& what) { note(stamp, what); };
  sinks.stop = [this] { return interrupted() || (scenario_.until_found && all_found()); };
  return sinks;
}

bool ScenarioWatch::all_found() const {
  const auto& verdicts = referee_.verdicts();
  return std::all_of(scenario_.expect.found.begin(), scenario_.expect.found.end(), [&](const std::string& name) {
    return std::any_of(verdicts.begin(), verdicts.end(), [&](const auto& v) { return v.name == name && v.found; });
  });
}

void ScenarioWatch::note(Stamp stamp, const std::string& what) { notes_.emplace(stamp, what); }

void ScenarioWatch::on_step(const mission::StepEvent& event) {
  const world::Truth truth = simulator_.truth();
  for (const world::ObjectTruth& object : truth.objects) {
    const bool wanted = std::find(objects_.begin(), objects_.end(), object.name) != objects_.end();
    if (wanted && judged_.insert(object.name).second) referee_.place(object);
  }
  const Pose2<World, Base> believed = T_world_map_ * event.pose.T_map_base;
  error_m_ = (believed.position() - truth.T_world_base.position()).norm();
  error_max_m_ = std::max(error_max_m_, error_m_);
  if (!(error_m_ <= kRight_m)) last_off_s_ = seconds(truth.stamp);
  path_m_.push_back(event.pose.T_map_base.position());
}

void ScenarioWatch::on_examined(const mission::ExaminationEvent& event) {
  note(event.stamp, fmt::format("region {} examined: {} segments", event.region, event.segments->size()));
  const auto objects = simulator_.truth().objects;
  if (const world::InstanceImage* instances = simulator_.instances_of(event.frame->stamp)) {
    std::vector<score::JudgedSegment> segments;
    for (const segment::Segment& s : *event.segments) segments.push_back({s.pixels, {s.centre_map}});
    for (const std::string& name : referee_.judge(event.stamp, segments, *instances, objects)) {
      note(event.stamp, "found " + name);
    }
  }
  const knowledge::Region& region = knowledge_.now().regions.at(static_cast<std::size_t>(event.region - 1));
  for (const world::ObjectTruth& object : objects) {
    if (!referee_.is_false({region.position_map}, region.cylinder.radius_m, {object})) robot_.examined(object.name);
  }
}

/// After each comparison: what is new, what has grown.
void ScenarioWatch::look_at_regions() {
  const std::vector<knowledge::Region>& now = knowledge_.now().regions;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const bool is_new = i >= regions_before_.size() || (regions_before_[i].withdrawn && !now[i].withdrawn);
    if (is_new && !now[i].withdrawn) {
      note_detected(now[i]);
      continue;
    }
    if (i >= regions_before_.size()) continue;
    const knowledge::Region& before = regions_before_[i];
    if (!before.withdrawn && now[i].withdrawn) {
      note(now[i].last_seen, fmt::format("region {} withdrawn", now[i].id));
    }
    if (now[i].withdrawn) continue;
    if (now[i].cylinder.radius_m > before.cylinder.radius_m || now[i].voxels > before.voxels) ++grown_;
    if (before.examined && !now[i].examined) ++reopened_;
  }
  regions_before_ = now;
}

void ScenarioWatch::note_detected(const knowledge::Region& region) {
  std::string what;
  for (const world::ObjectTruth& object : simulator_.truth().objects) {
    if (referee_.is_false({region.position_map}, region.cylinder.radius_m, {object})) continue;
    what += (what.empty() ? " of " : ", ") + object.name;
    detected_.insert(object.name);
    robot_.detected(object.name);
  }
  const auto [known, is_new] = false_regions_.emplace(region.id, what.empty());
  if (!is_new) known->second = known->second && what.empty();
  note(region.first_seen, fmt::format("region {}{}", region.id, what.empty() ? " of nothing" : what));
}

score::RunRecord ScenarioWatch::record(const mission::SearchReport& result) const {
  score::RunRecord run;
  run.end = scenario_.until_found && all_found() ? "found" : std::string(mission::to_string(result.end));
  run.exit_status = run.end == (scenario_.until_found ? "found" : "explored") ? kGoalMet : kGoalNotMet;
  for (const score::ObjectVerdict& v : referee_.verdicts()) {
    if (!v.found) continue;
    run.found_at_s[v.name] = v.found_at_s;
    run.category[v.name] = "novel";  // what the dynamic method reports, it reports as novel
  }
  run.why = result.why;
  for (const mission::NavigationError error : mission::kNavigationErrors) {
    const auto counted = result.navigation_errors.find(error);
    const int times = counted == result.navigation_errors.end() ? 0 : counted->second;
    run.navigation_errors[std::string(mission::to_string(error))] = times;
  }
  run.detected = detected_;
  run.not_happened = robot_.not_happened();
  const knowledge::Knowledge& known = knowledge_.now();
  const auto count = [](const auto& all, const auto& which) {
    return static_cast<double>(std::count_if(all.begin(), all.end(), which));
  };
  const bool right = error_m_ <= kRight_m;
  const double recovery_s = last_off_s_ - last_disturbance_s(robot_.happened(), scenario_.script);
  run.numbers = {
      {"duration", seconds(result.ended)},
      {"distance", result.distance_m},
      {"coverage", result.coverage},
      {"collisions", static_cast<double>(simulator_.collisions().size())},
      {"regions", static_cast<double>(known.regions.size())},
      {"regions_false", count(false_regions_, [](const auto& r) { return r.second; })},
      {"regions_withdrawn", count(known.regions, [](const knowledge::Region& r) { return r.withdrawn; })},
      {"regions_grown", grown_},
      {"regions_reopened", reopened_},
      {"segmentations", result.segmentation_actions},
      {"plans", result.plans},
      {"failed_actions", result.failed_actions},
      {"view_triangles", result.view_triangles},
      {"views_dropped", count(known.views, [](const knowledge::View& v) { return v.dropped; })},
      {"localization_error", error_m_},
      {"localization_error_max", error_max_m_},
      {"recovery", right ? std::max(0.0, recovery_s) : std::numeric_limits<double>::infinity()},
  };
  return run;
}

std::string ScenarioWatch::log() const {
  std::multimap<Stamp, std::string> all = notes_;
  for (const sim::Happening& h : robot_.happened()) all.emplace(h.stamp, "* " + h.what);
  for (const world::Collision& c : simulator_.collisions()) {
    all.emplace(c.stamp, "! " + c.link + " touched " + c.body);
  }
  std::string text;
  for (const auto& [stamp, what] : all) text += fmt::format("{:9.2f} s  {}\n", seconds(stamp), what);
  return text;
}

report::FloorPlan ScenarioWatch::floor_plan(const FloorGrid& floor, const FloorGrid& seen) const {
  report::FloorPlan plan;
  plan.grid = floor;
  plan.seen = seen;
  for (std::size_t i = 0; i < path_m_.size(); i += kPathStep) plan.path_m.push_back(path_m_[i]);
  for (const knowledge::View& view : knowledge_.now().views) {
    plan.views.push_back({view.T_map_base, view.angle_rad, view.height_m, view.visited_at.has_value()});
  }
  for (const knowledge::Region& region : knowledge_.now().regions) {
    plan.regions.push_back({region.cylinder.centre_map, region.cylinder.radius_m, region.withdrawn});
  }
  const Transform<Map, World> T_map_world = T_world_map_.lift().inverse();
  for (const score::ObjectVerdict& v : referee_.verdicts()) {
    plan.objects.push_back({(T_map_world.T * v.position_world).head<2>(), v.name, v.found});
  }
  return plan;
}

}  // namespace amiss::app
