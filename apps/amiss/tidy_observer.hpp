// Watches a tidy-up run for the run folder and the referee; tells the mission nothing but when to stop.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mission/search_method.hpp"
#include "progress_line.hpp"
#include "report/run_folder.hpp"
#include "report/tidy_report.hpp"
#include "report/trajectory.hpp"
#include "score/alignment.hpp"
#include "score/referee.hpp"
#include "sim/simulator.hpp"

namespace amiss::app {

class TidyObserver {
 public:
  /// `tell` takes each line of the log, too.
  using Tell = std::function<void(Stamp, const std::string&)>;
  TidyObserver(sim::Simulator& simulator, score::Referee& referee, const report::RunFolder& folder,
               ProgressLine& progress, Tell tell);

  /// Sinks that live as long as the observer.
  [[nodiscard]] mission::Sinks sinks(bool stop_when_found);

  void fill(report::TidyReport& report, const mission::SearchReport& result, const knowledge::Knowledge& knowledge,
            const Pose2<World, Map>& T_world_map) const;
  [[nodiscard]] std::string floor_plan(const FloorGrid& floor, const FloorGrid& seen,
                                       const knowledge::Knowledge& knowledge,
                                       const Pose2<World, Map>& T_world_map) const;
  /// Truth and estimate as TUM files; returns their text.
  std::string save_trajectories() const;
  [[nodiscard]] const std::string& log() const { return log_; }

 private:
  /// Segmentation actions until an object was found, and the simulated time that they took.
  struct SegmentedUntil {
    int actions = 0;
    Duration cost{};
  };
  void on_step(const mission::StepEvent& event);
  void remember_truth(Stamp frame);
  void on_examined(const mission::ExaminationEvent& event);
  void save_picture(const mission::ExaminationEvent& event, const std::string& object) const;
  void note(Stamp stamp, const std::string& what);

  sim::Simulator& simulator_;
  score::Referee& referee_;
  const report::RunFolder& folder_;
  ProgressLine& progress_;
  std::vector<score::PosePair> poses_;
  std::optional<world::InstanceImage> segmented_;  // ids and true places of the frame that is being segmented
  std::vector<world::ObjectTruth> objects_then_;
  std::vector<double> comparisons_ms_, segmentations_ms_;
  Duration segmentation_cost_{};
  std::map<std::string, SegmentedUntil> found_after_;  // by object
  Tell tell_;
  std::string log_;
};

}  // namespace amiss::app
