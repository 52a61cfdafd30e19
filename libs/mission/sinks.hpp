// What a mission tells while it works, and the one thing that it is told: whether to stop.
// Sinks are attached by apps (progress line, run folder, referee); none of them can change a decision.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "change/difference.hpp"
#include "core/floor_grid.hpp"
#include "core/sensors.hpp"
#include "knowledge/knowledge_base.hpp"
#include "mission/visit_plan.hpp"
#include "motion/path.hpp"
#include "robot/robot.hpp"
#include "segment/segment.hpp"

namespace amiss::mission {

/// One control period.
struct StepEvent {
  PoseEstimate pose;
  bool bumper = false;
  robot::HeadState head;
};

/// A camera frame that arrived; it was taken at its own stamp.
struct FrameEvent {
  const RgbdFrame* frame = nullptr;  // lives during the call
  Transform<Map, Camera> T_map_camera;
};

/// One segmentation action: the frame that was segmented and what came out.
struct ExaminationEvent {
  int region = 0;                    // id in the knowledge base, 0 when the whole frame was segmented
  Stamp stamp;                       // when the result was there
  const RgbdFrame* frame = nullptr;  // lives during the call
  Transform<Map, Camera> T_map_camera;
  const std::vector<segment::Segment>* segments = nullptr;
  double wall_ms = 0.0;  // of the segmentation
  Duration cost{};       // simulated time that it took
};

/// A plan that is about to be carried out.
struct PlanEvent {
  Stamp stamp;
  int number = 0;  // from 1
  std::string problem_pddl, plan_text;
  const std::vector<PlannedStep>* steps = nullptr;  // lives during the call
};

/// A step of the latest plan that begins, from 0.
struct ActionEvent {
  Stamp stamp;
  std::size_t step = 0;
};

/// A way that is about to be driven.
struct PathEvent {
  Stamp stamp;
  const motion::Path* path = nullptr;  // lives during the call
};

/// One comparison of the current map with the reference.
struct DifferenceEvent {
  Stamp stamp;
  double wall_ms = 0.0;
  const change::Difference* difference = nullptr;  // lives during the call
};

struct ProgressEvent {
  Stamp stamp;
  double seen_m2 = 0.0;  // floor
  int regions = 0;       // not withdrawn
  int examined = 0;
};

struct Sinks {
  std::function<void(const StepEvent&)> step = [](const StepEvent&) {};
  std::function<void(const FrameEvent&)> frame = [](const FrameEvent&) {};
  std::function<void(const FrameEvent&)> segmenting = [](const FrameEvent&) {};  // begins; `examined` tells the end
  std::function<void(const ExaminationEvent&)> examined = [](const ExaminationEvent&) {};
  std::function<void(const PlanEvent&)> planned = [](const PlanEvent&) {};
  std::function<void(const ActionEvent&)> acting = [](const ActionEvent&) {};
  std::function<void(const PathEvent&)> path = [](const PathEvent&) {};
  std::function<void(const DifferenceEvent&)> compared = [](const DifferenceEvent&) {};
  std::function<void(const ProgressEvent&)> progress = [](const ProgressEvent&) {};
  std::function<void(Stamp, const std::string&)> log = [](Stamp, const std::string&) {};
  std::function<bool()> stop = [] { return false; };           // asked each period; the mission then ends where it is
  std::function<double()> wall_clock_ms = [] { return 0.0; };  // for events only
};

}  // namespace amiss::mission
