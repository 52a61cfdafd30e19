#include "recording/replay.hpp"

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

class Replayer {
 public:
  Replayer(const Setup& setup, const mission::Reference& reference, const mission::Params& params,
           knowledge::KnowledgeBase& knowledge, const mission::Sinks& sinks)
      : params_(params),
        knowledge_(knowledge),
        robot_(setup),
        perception_(robot_,
                    std::make_unique<mission::LocalizerTracker>(
                        mission::search_localizer(reference.floor, params.localizer, setup.seed)),
                    reference.floor, params.voxels, params.perception, sinks),
        differencer_(reference.reference, reference.floor, params.difference) {}

  bool operator()(robot::Observation& observation) {
    ++report.periods;
    if (observation.frame) ++report.frames;
    robot_.will_say(std::move(observation));
    return perception_.step({});
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
  RecordedRobot robot_;
  mission::Perception perception_;
  change::Differencer differencer_;
  std::optional<mission::LocatedFrame> segmented_;
};

}  // namespace

ReplayReport replay(Source& recording, const mission::Reference& reference, const mission::Params& params,
                    knowledge::KnowledgeBase& knowledge, const mission::Sinks& sinks) {
  Replayer replayer(recording.setup(), reference, params, knowledge, sinks);
  while (auto entry = recording.next()) {
    if (!std::visit(replayer, *entry)) break;
  }
  replayer.finish();
  replayer.report.complete = recording.complete();
  return std::move(replayer.report);
}

}  // namespace amiss::recording
