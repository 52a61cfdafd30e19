// The dynamic method of chapter 4: search a place for what lies on its floor and did not lie there before.
// Robot, reference, parameters, seed -> SearchReport; what was found stands in the knowledge base. Knows no truth.
#pragma once

#include <map>
#include <set>

#include "mission/params.hpp"
#include "mission/reference.hpp"
#include "mission/visit_plan.hpp"

namespace amiss::mission {

enum class SearchEnd { kExplored, kStopped, kTimeLimit, kGaveUp };
[[nodiscard]] std::string_view to_string(SearchEnd end);

struct SearchReport {
  SearchEnd end = SearchEnd::kExplored;
  int segmentation_actions = 0;
  int plans = 0;
  int failed_actions = 0;
  int view_triangles = 0;  // generated
  double coverage = 0.0;   // part of the reachable floor that was seen
  double distance_m = 0.0;
  Duration segmenting{}, driving{};
  Stamp ended;
};

class Search {
 public:
  /// `keep_searching`: when all is explored, look again until the mission is stopped or out of time.
  /// All references outlive the search.
  Search(robot::Robot& robot, const Reference& reference, knowledge::KnowledgeBase& knowledge,
         const plan::Domain& domain, const Params& params, std::uint64_t seed, bool keep_searching, const Sinks& sinks);

  SearchReport run();

  [[nodiscard]] const mapping::VoxelMap& voxels() const { return perception_.voxels(); }
  [[nodiscard]] const FloorGrid& seen_floor() { return perception_.obstacles().seen_floor(); }

 private:
  enum class Progress { kDone, kReplan, kEnded };
  /// Which view triangles are worth a way: those of the thesis, then those that show what these left out, then, when
  /// all was seen and still something is to be found, all of them again.
  enum class Looking { kCoarsely, kFinely, kAgain };

  // The thesis' loop: explore -> compare -> merge -> plan -> drive and look -> segment.
  Progress carry_out(const VisitPlan& plan);
  Progress go_to(const Visit& visit);
  Progress explore(const Visit& visit);
  Progress examine(const Visit& visit);
  Progress failed(const Visit& visit, const std::string& why);

  bool compare();                    // with the reference; did the regions change?
  [[nodiscard]] bool compare_due();  // the same, not more often than wanted
  bool add_view_triangles();         // false: there is nothing left to see
  std::vector<Visit> open_visits();
  std::optional<Visit> viewpoint_of(const knowledge::Region& region, const motion::PathLengths& ways);
  std::optional<VisitPlan> make_plan(const std::vector<Visit>& visits);
  Progress wait();
  [[nodiscard]] bool is_covered(const view::ViewTriangle& view);
  std::vector<view::ViewTriangle> sample_view_triangles();
  [[nodiscard]] bool is_pointless(const Visit& visit);
  [[nodiscard]] double coverage();
  void report_progress();

  const Reference& reference_;
  knowledge::KnowledgeBase& knowledge_;
  const plan::Domain& domain_;
  const Params& params_;
  const bool keep_searching_;
  Looking looking_ = Looking::kCoarsely;
  const Sinks& sinks_;
  RandomStream triangles_random_;
  mapping::ObstacleLayer static_obstacles_;
  Perception perception_;
  Navigator navigator_;
  change::Differencer differencer_;
  view::Head head_;
  std::map<int, view::ViewTriangle> open_views_;                   // by id in the knowledge base
  std::map<int, std::vector<Pose2<Map, Base>>> tried_viewpoints_;  // by region, those that failed
  std::map<int, robot::HeadState> gaze_;                           // by region, for its current viewpoint
  std::set<int> given_up_;                                         // regions without a viewpoint that works
  std::size_t reachable_cells_ = 0;
  Stamp next_comparison_;
  SearchReport report_;
};

}  // namespace amiss::mission
