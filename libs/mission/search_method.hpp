// What both methods of chapter 4 share: senses and ways of the robot, view triangles, plans and how they are carried
// out, and what a segmentation costs. The dynamic method (search.hpp) and the static one (static_search.hpp) differ in
// what they look at and when they segment, in nothing else. Robot, reference, parameters, seed -> SearchReport; what
// was found stands in the knowledge base. Knows no truth.
#pragma once

#include <map>

#include "mission/params.hpp"
#include "mission/reference.hpp"
#include "mission/visit_plan.hpp"

namespace amiss::mission {

enum class SearchEnd { kExplored, kStopped, kTimeLimit, kGaveUp, kLost, kSensorLost };
inline constexpr SearchEnd kSearchEnds[] = {SearchEnd::kExplored, SearchEnd::kStopped, SearchEnd::kTimeLimit,
                                            SearchEnd::kGaveUp,   SearchEnd::kLost,    SearchEnd::kSensorLost};
[[nodiscard]] std::string_view to_string(SearchEnd end);

struct SearchReport {
  SearchEnd end = SearchEnd::kExplored;
  std::string why;  // kLost and kSensorLost: what the trouble was
  std::map<NavigationError, int> navigation_errors;
  int segmentation_actions = 0;
  int plans = 0;
  int failed_actions = 0;
  int view_triangles = 0;  // generated
  double coverage = 0.0;   // part of the reachable floor that was seen
  double distance_m = 0.0;
  Duration segmenting{}, driving{};
  Duration segmentation_cost{};  // simulated time that the segmentations themselves took
  Stamp ended;
};

/// The particle filter of a search; its random stream is named after it.
[[nodiscard]] localize::Localizer search_localizer(const FloorGrid& floor, const localize::LocalizerParams& params,
                                                   std::uint64_t seed, const Pose2<Map, Base>& start = {});
/// What an examination of `region` showed (0: the whole frame).
void add_objects(knowledge::KnowledgeBase& knowledge, int region, Stamp frame,
                 const std::vector<segment::Segment>& segments);

class SearchMethod {
 public:
  /// `keep_searching`: when all is explored, look again until the mission is stopped or out of time.
  /// All references outlive the search.
  SearchMethod(robot::Robot& robot, const Reference& reference, knowledge::KnowledgeBase& knowledge,
               const plan::Domain& domain, const Params& params, std::uint64_t seed, bool keep_searching,
               const Sinks& sinks);
  virtual ~SearchMethod() = default;
  SearchMethod(const SearchMethod&) = delete;
  SearchMethod& operator=(const SearchMethod&) = delete;

  SearchReport run();

  [[nodiscard]] const mapping::VoxelMap& voxels() { return perception_.voxels(); }
  [[nodiscard]] const FloorGrid& seen_floor() { return perception_.obstacles().seen_floor(); }

 protected:
  enum class Progress { kDone, kReplan, kEnded };
  static constexpr double kWayTolerance = 0.4;  // m round a place, for way lengths

  // In what the methods differ.
  virtual void take_stock() {}  // before each plan
  virtual std::vector<Visit> open_visits() = 0;
  virtual bool add_view_triangles() = 0;             // false: there is nothing left to see
  virtual Progress arrived(const Visit& visit) = 0;  // and stands there
  virtual Progress failed(const Visit& visit, const std::string& why);
  virtual bool replan_due() { return false; }  // asked while driving, like the next one
  virtual bool is_pointless(const Visit&) { return false; }
  virtual void recovered() {}  // from trouble, in which much may have been misjudged

  using Segmenter = std::function<segment::Segmentation(const LocatedFrame&)>;
  /// Looks there until the head has settled and the last frame is of then; kReplan where trouble came between.
  Progress look(const robot::HeadState& gaze);
  /// One segmentation action: the last frame through the segmenter, which costs simulated time. `region`: its id, 0
  /// for a whole frame. False when the mission ended meanwhile.
  bool segment(int region, const robot::HeadState& gaze, double cost_s, const Segmenter& segmenter);
  void remember(std::vector<view::ViewTriangle> triangles);
  /// Visits of the open view triangles that can be reached and are `wanted`; the others are dropped.
  std::vector<Visit> open_view_visits(const motion::PathLengths& ways,
                                      const std::function<bool(const view::ViewTriangle&)>& wanted);
  std::vector<view::ViewTriangle> sample(const FloorGrid& covered, const view::TriangleParams& params);
  [[nodiscard]] double coverage();
  void report_progress();

  const Reference& reference_;
  knowledge::KnowledgeBase& knowledge_;
  const Params& params_;
  const bool keep_searching_;
  const Sinks& sinks_;
  mapping::ObstacleLayer static_obstacles_;
  Perception perception_;
  Navigator navigator_;
  std::map<int, view::ViewTriangle> open_views_;  // by id in the knowledge base
  SearchReport report_;

 private:
  std::optional<VisitPlan> make_plan(const std::vector<Visit>& visits);
  Progress carry_out(const VisitPlan& plan);
  Progress go_to(const Visit& visit);
  Progress wait();
  /// Stands, or looks round where the pose is lost, until the trouble is over; kEnded when patience is.
  Progress recover();
  [[nodiscard]] bool is_well() const { return perception_.pose().converged && !perception_.trouble(); }
  [[nodiscard]] SearchEnd ended_because() const;

  const plan::Domain& domain_;
  RandomStream triangles_random_;
  std::optional<Trouble> given_in_to_;
  std::size_t reachable_cells_ = 0;
};

}  // namespace amiss::mission
