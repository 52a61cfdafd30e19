#include "tidy_observer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <tuple>

#include "interrupt.hpp"
#include "page/picture.hpp"
#include "report/floor_plan.hpp"

namespace amiss::app {

namespace {

constexpr std::size_t kTrajectoryStep = 5;  // control periods between two poses in the files

double wall_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::pair<double, double> mean_and_max(const std::vector<double>& values) {
  if (values.empty()) return {0.0, 0.0};
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {sum / static_cast<double>(values.size()), *std::max_element(values.begin(), values.end())};
}

}  // namespace

TidyObserver::TidyObserver(sim::Simulator& simulator, score::Referee& referee, const report::RunFolder& folder,
                           ProgressLine& progress, Tell tell)
    : simulator_(simulator), referee_(referee), folder_(folder), progress_(progress), tell_(std::move(tell)) {}

mission::Sinks TidyObserver::sinks(bool stop_when_found) {
  mission::Sinks sinks;
  sinks.step = [this](const mission::StepEvent& event) { on_step(event); };
  sinks.segmenting = [this](const mission::FrameEvent& event) { remember_truth(event.frame->stamp); };
  sinks.examined = [this](const mission::ExaminationEvent& event) { on_examined(event); };
  sinks.planned = [this](const mission::PlanEvent& event) {
    const std::string name = fmt::format("plans/{:03}", event.number);
    folder_.save(name + "_problem.pddl", event.problem_pddl);
    folder_.save(name + "_plan.txt", event.plan_text);
    note(event.stamp, fmt::format("plan {}", event.number));
  };
  sinks.compared = [this](const mission::DifferenceEvent& event) { comparisons_ms_.push_back(event.wall_ms); };
  sinks.progress = [this](const mission::ProgressEvent& event) {
    progress_.show(event, fmt::format("{} of {} found", referee_.found(), referee_.verdicts().size()));
  };
  sinks.log = [this](Stamp stamp, const std::string& what) { note(stamp, what); };
  sinks.stop = [this, stop_when_found] { return interrupted() || (stop_when_found && referee_.all_found()); };
  sinks.wall_clock_ms = wall_ms;
  return sinks;
}

void TidyObserver::note(Stamp stamp, const std::string& what) {
  log_ += fmt::format("{:9.2f} s  {}\n", seconds(stamp), what);
  tell_(stamp, what);
}

void TidyObserver::on_step(const mission::StepEvent& event) {
  poses_.push_back({event.pose.stamp, simulator_.truth().T_world_base, event.pose.T_map_base});
}

/// Taken when a segmentation begins: the simulator keeps the last frames only, and a segmentation takes seconds.
void TidyObserver::remember_truth(Stamp frame) {
  const world::InstanceImage* instances = simulator_.instances_of(frame);
  segmented_ = instances != nullptr ? std::optional(*instances) : std::nullopt;
  objects_then_ = simulator_.truth().objects;
}

void TidyObserver::on_examined(const mission::ExaminationEvent& event) {
  segmentations_ms_.push_back(event.wall_ms);
  segmentation_cost_ += event.cost;
  const std::string where = event.region == 0 ? "frame segmented" : fmt::format("region {} examined", event.region);
  note(event.stamp, fmt::format("{}: {} segments", where, event.segments->size()));
  if (!segmented_) {
    note(event.stamp, "the frame was too old to be judged");
    return;
  }
  std::vector<score::JudgedSegment> segments;
  for (const segment::Segment& s : *event.segments) segments.push_back({s.pixels, {s.centre_map}});
  const auto found = referee_.judge(event.stamp, segments, *segmented_, objects_then_);
  for (const std::string& object : found) {
    note(event.stamp, "found " + object);
    found_after_[object] = {static_cast<int>(segmentations_ms_.size()), segmentation_cost_};
    save_picture(event, object);
  }
}

void TidyObserver::save_picture(const mission::ExaminationEvent& event, const std::string& object) const {
  const RgbdFrame& frame = *event.frame;
  folder_.save("objects/" + object + ".png",
               report::to_png(page::outlined(frame, *event.segments), frame.intrinsics.width, frame.intrinsics.height));
}

void TidyObserver::fill(report::TidyReport& report, const mission::SearchReport& result,
                        const knowledge::Knowledge& knowledge, const Pose2<World, Map>& T_world_map) const {
  for (const score::ObjectVerdict& v : referee_.verdicts()) {
    report::ReportedObject object{v.name, v.kind, v.position_world, v.found, v.found_at_s, v.error_m, v.covered};
    if (const auto found = found_after_.find(v.name); found != found_after_.end()) {
      object.segmentations = found->second.actions;
      object.segmentation_cost_s = seconds(found->second.cost);
    }
    report.objects.push_back(std::move(object));
  }
  for (const world::Collision& c : simulator_.collisions()) {
    report.collisions.push_back({seconds(c.stamp), c.link, c.body, c.position.p});
  }
  const auto objects = simulator_.truth().objects;
  for (const knowledge::Region& region : knowledge.regions) {
    ++report.regions_detected;
    if (region.withdrawn) ++report.regions_withdrawn;
    if (referee_.is_false({region.position_map}, region.cylinder.radius_m, objects)) ++report.regions_false;
  }
  report.why = result.why;
  for (const auto& [error, times] : result.navigation_errors) {
    report.navigation_errors[std::string(mission::to_string(error))] = times;
  }
  report.segmentation_actions = result.segmentation_actions;
  report.segments = referee_.segments();
  report.segments_false = referee_.false_segments();
  report.segmentation_cost_s = seconds(result.segmentation_cost);
  std::tie(report.segmentation_mean_ms, report.segmentation_max_ms) = mean_and_max(segmentations_ms_);
  report.view_triangles = result.view_triangles;
  report.plans = result.plans;
  report.failed_actions = result.failed_actions;
  report.coverage = result.coverage;
  report.distance_m = result.distance_m;
  report.simulated_s = seconds(result.ended);
  report.driving_s = seconds(result.driving);
  report.segmenting_s = seconds(result.segmenting);
  const score::LocalizationError error = score::localization_error(poses_, T_world_map);
  report.rmse_m = error.rmse_m;
  report.rmse_rad = error.rmse_rad;
  report.max_m = error.max_m;
  report.differencing_calls = static_cast<int>(comparisons_ms_.size());
  std::tie(report.differencing_mean_ms, report.differencing_max_ms) = mean_and_max(comparisons_ms_);
}

std::string TidyObserver::floor_plan(const FloorGrid& floor, const FloorGrid& seen,
                                     const knowledge::Knowledge& knowledge,
                                     const Pose2<World, Map>& T_world_map) const {
  report::FloorPlan plan;
  plan.grid = floor;
  plan.seen = seen;
  for (std::size_t i = 0; i < poses_.size(); i += kTrajectoryStep) {
    plan.path_m.push_back(poses_[i].T_map_base.position());
  }
  for (const knowledge::View& view : knowledge.views) {
    plan.views.push_back({view.T_map_base, view.angle_rad, view.height_m, view.visited_at.has_value()});
  }
  for (const knowledge::Region& region : knowledge.regions) {
    plan.regions.push_back({region.cylinder.centre_map, region.cylinder.radius_m, region.withdrawn});
  }
  const Transform<Map, World> T_map_world = T_world_map.lift().inverse();
  for (const score::ObjectVerdict& v : referee_.verdicts()) {
    plan.objects.push_back({(T_map_world.T * v.position_world).head<2>(), v.name, v.found});
  }
  return report::to_png(plan);
}

std::string TidyObserver::save_trajectories() const {
  report::TumTrajectory truth, estimate;
  for (std::size_t i = 0; i < poses_.size(); i += kTrajectoryStep) {
    const score::PosePair& p = poses_[i];
    truth.add(p.stamp, p.T_world_base.x_m, p.T_world_base.y_m, p.T_world_base.yaw_rad);
    estimate.add(p.stamp, p.T_map_base.x_m, p.T_map_base.y_m, p.T_map_base.yaw_rad);
  }
  folder_.save("trajectory_truth.txt", truth.text());
  folder_.save("trajectory_estimate.txt", estimate.text());
  return truth.text() + estimate.text();
}

}  // namespace amiss::app
