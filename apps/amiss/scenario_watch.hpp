// Watches a scenario's run with the truth at hand: records what its expectations speak of, and tells the script when
// something was detected or examined. Tells the mission nothing but when to stop.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "mission/search.hpp"
#include "report/floor_plan.hpp"
#include "scenario/scenario.hpp"
#include "score/referee.hpp"
#include "sim/scripted_robot.hpp"

namespace amiss::app {

class ScenarioWatch {
 public:
  /// What the script adds is judged by the referee as soon as it is there.
  ScenarioWatch(const scenario::Scenario& scenario, sim::Simulator& simulator, sim::ScriptedRobot& robot,
                score::Referee& referee, const knowledge::KnowledgeBase& knowledge,
                const Pose2<World, Map>& T_world_map);

  /// Sinks that live as long as the watch.
  [[nodiscard]] mission::Sinks sinks();
  [[nodiscard]] score::RunRecord record(const mission::SearchReport& result) const;
  [[nodiscard]] std::string log() const;
  [[nodiscard]] report::FloorPlan floor_plan(const FloorGrid& floor, const FloorGrid& seen) const;

 private:
  void on_step(const mission::StepEvent& event);
  void on_examined(const mission::ExaminationEvent& event);
  void look_at_regions();
  void note_detected(const knowledge::Region& region);
  [[nodiscard]] bool all_found() const;
  void note(Stamp stamp, const std::string& what);

  const scenario::Scenario& scenario_;
  std::vector<std::string> objects_;
  sim::Simulator& simulator_;
  sim::ScriptedRobot& robot_;
  score::Referee& referee_;
  const knowledge::KnowledgeBase& knowledge_;
  Pose2<World, Map> T_world_map_;

  std::set<std::string> judged_, detected_;
  std::map<int, bool> false_regions_;  // by id: was no object there when it was detected?
  std::vector<knowledge::Region> regions_before_;
  int grown_ = 0, reopened_ = 0;
  double error_m_ = 0.0, error_max_m_ = 0.0, last_off_s_ = 0.0;
  std::vector<Eigen::Vector2d> path_m_;
  std::multimap<Stamp, std::string> notes_;
};

}  // namespace amiss::app
