#include "recording/replay.hpp"

#include <cmath>
#include <numbers>

#include "core/result.hpp"
#include "mission/perception.hpp"
#include "mission/search.hpp"

namespace amiss::recording {

namespace {

/// Says what was recorded; nothing moves it.
class RecordedRobot final : public robot::Robot {
 public:
  explicit RecordedRobot(const Setup& setup) { model_.T_base_laser = setup.T_base_laser; }
  [[nodiscard]] const robot::Model& model() const override { return model_; }
  void command(const robot::Command&) override {}
  robot::Observation observe() override { return std::move(next_); }
  void will_say(robot::Observation observation) { next_ = std::move(observation); }

 private:
  robot::Model model_;
  robot::Observation next_;
};

/// All of the cylinder's rims are in the image, and nothing of them is nearer than that.
bool is_in_view(const knowledge::Cylinder& region, const mission::LocatedFrame& frame, double min_depth_m) {
  constexpr int kPoints = 8;  // of half a rim
  const CameraIntrinsics& camera = frame.captured.frame.intrinsics;
  const Eigen::Isometry3d T_camera_map = frame.T_map_camera.T.inverse();
  for (int i = 0; i < 2 * kPoints; ++i) {
    const double angle = std::numbers::pi * i / kPoints;
    const Eigen::Vector2d rim = region.centre_map + region.radius_m * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    for (const double z : {region.z_low_m, region.z_high_m}) {
      const Eigen::Vector3d p = T_camera_map * Eigen::Vector3d(rim.x(), rim.y(), z);
      if (p.z() < min_depth_m) return false;
      const double u = camera.fx * p.x() / p.z() + camera.cx, v = camera.fy * p.y() / p.z() + camera.cy;
      if (u < 0.0 || v < 0.0 || u > camera.width - 1.0 || v > camera.height - 1.0) return false;
    }
  }
  return true;
}

class Replayer {
 public:
  Replayer(const Source& source, const mission::Reference& reference, const mission::Params& params,
           knowledge::KnowledgeBase& knowledge, const mission::Sinks& sinks)
      : params_(params),
        knowledge_(knowledge),
        decides_(!source.tells_decisions()),
        robot_(source.setup()),
        perception_(robot_,
                    std::make_unique<mission::LocalizerTracker>(mission::search_localizer(
                        reference.floor, params.localizer, source.setup().seed, source.setup().T_map_base)),
                    reference.floor, params.voxels, params.perception, sinks),
        differencer_(reference.reference, reference.floor, params.difference) {}

  bool operator()(robot::Observation& observation) {
    ++report.periods;
    if (observation.frame) ++report.frames;
    robot_.will_say(std::move(observation));
    const bool goes_on = perception_.step({});
    if (decides_ && perception_.now() >= next_comparison_) {
      compare();
      next_comparison_ = perception_.now() + duration_of(params_.search.compare_s);
      const std::vector<knowledge::Region> regions = knowledge_.now().regions;  // looking changes them
      for (const knowledge::Region& region : regions) look_at(region);
    }
    return goes_on;
  }
  bool operator()(const Decision& decision) {
    if (decision.kind == Decision::Kind::kCompared) compare();
    if (decision.kind == Decision::Kind::kExamined) examine(decision.region);
    return true;
  }
  bool operator()(const Segmenting& segmenting) {
    if (!perception_.last_frame()) throw InputError("a segmentation comes before the first frame");
    segmented_ = *perception_.last_frame();
    parse_colour(segmenting.colour_message, segmented_->captured.frame);
    return true;
  }
  void finish() {
    if (decides_) compare();
    report.pose = perception_.pose();
    report.voxels = perception_.voxels();
  }

  ReplayReport report;

 private:
  void compare() {
    ++report.comparisons;
    const change::Difference& difference = differencer_.update(perception_.voxels());
    const auto regions = change::regions(difference.appeared, perception_.voxels(), params_.region);
    knowledge_.merge(
        mission::sightings(regions), [](const knowledge::Region&) { return true; }, perception_.now());
  }
  /// What a mission drives for: the whole region in one frame, near enough.
  void look_at(const knowledge::Region& region) {
    const auto& last = perception_.last_frame();
    if (region.examined || region.withdrawn || !last || last->captured.frame.colour.empty()) return;
    const double far_m = params_.view_pose.max_dist_m + region.cylinder.radius_m;
    if ((last->T_map_camera.position().head<2>() - region.cylinder.centre_map).norm() > far_m) return;
    if (!is_in_view(region.cylinder, *last, params_.view_pose.min_depth_m)) return;
    segmented_ = last;
    examine(region.id);
  }
  void examine(int region) {
    if (!segmented_) throw InputError("an examination ends that did not begin");
    const auto& [captured, T_map_camera] = *segmented_;
    segment::Segmentation result;
    if (region == 0) {
      result = segment::segment_frame(captured.frame, T_map_camera, params_.segment);
    } else {
      const auto& known = knowledge_.now().regions;
      if (region < 0 || static_cast<std::size_t>(region) > known.size()) {
        throw InputError("region " + std::to_string(region) + " is examined, which was not found");
      }
      const knowledge::Cylinder& c = known[static_cast<std::size_t>(region - 1)].cylinder;
      result = segment::segment_region(captured.frame, T_map_camera, {c.centre_map, c.radius_m, c.z_low_m, c.z_high_m},
                                       params_.segment);
      knowledge_.mark_examined(region, perception_.now());
    }
    mission::add_objects(knowledge_, region, captured.frame.stamp, result.segments);
    ++report.segmentations;
    segmented_.reset();
  }

  const mission::Params& params_;
  knowledge::KnowledgeBase& knowledge_;
  bool decides_;  // where to compare and to segment, since no mission did
  Stamp next_comparison_;
  RecordedRobot robot_;
  mission::Perception perception_;
  change::Differencer differencer_;
  std::optional<mission::LocatedFrame> segmented_;
};

}  // namespace

ReplayReport replay(Source& recording, const mission::Reference& reference, const mission::Params& params,
                    knowledge::KnowledgeBase& knowledge, const mission::Sinks& sinks) {
  Replayer replayer(recording, reference, params, knowledge, sinks);
  while (auto entry = recording.next()) {
    if (!std::visit(replayer, *entry)) break;
  }
  replayer.finish();
  replayer.report.complete = recording.complete();
  return std::move(replayer.report);
}

}  // namespace amiss::recording
