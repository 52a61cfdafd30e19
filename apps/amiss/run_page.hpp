// What there is to see of a run: its timeline in the run folder, report.html, and the page for who watches.
#pragma once

#include <memory>

#include "mission/search_method.hpp"
#include "page/recorder.hpp"
#include "page/server.hpp"
#include "report/run_folder.hpp"
#include "score/referee.hpp"
#include "sim/scripted_robot.hpp"
#include "view_options.hpp"

namespace amiss::app {

class RunPage {
 public:
  /// Serves at once where that is wanted, so that the mapping run does not keep a page waiting.
  RunPage(const report::RunFolder& folder, const ViewOptions& options, bool threaded);

  /// Whom the page may ask, from begin() to settle().
  struct Watched {
    const sim::Simulator& simulator;
    const score::Referee& referee;
    Transform<World, Map> T_world_map;  // as the referee has it
    const knowledge::KnowledgeBase& knowledge;
    const sim::ScriptedRobot* script = nullptr;  // where there is one
  };
  void begin(const page::Beginning& beginning, const Watched& watched,
             std::function<const mapping::VoxelMap&()> voxels);
  void attach(mission::Sinks& sinks);
  /// The search is over: a last look at what it left.
  void settle();
  /// The last event, and report.html.
  void end(const std::string& report_json);
  /// Serves on as long as a page is open, or until interrupted.
  void linger() const;

 private:
  report::RunFolder folder_;
  page::History history_;
  page::Pace pace_;
  page::Recorder recorder_;
  bool begun_ = false;
  std::unique_ptr<page::Server> server_;
};

}  // namespace amiss::app
