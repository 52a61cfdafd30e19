// The dynamic method of chapter 4: search a place for what lies on its floor and did not lie there before.
// View triangles guide the robot; what differs from the reference becomes a region, and only regions are segmented.
#pragma once

#include <set>

#include "mission/search_method.hpp"

namespace amiss::mission {

/// Regions of the difference as the knowledge base takes them.
[[nodiscard]] std::vector<knowledge::Sighting> sightings(const std::vector<change::Region>& regions);

class Search : public SearchMethod {
 public:
  Search(robot::Robot& robot, const Reference& reference, knowledge::KnowledgeBase& knowledge,
         const plan::Domain& domain, const Params& params, std::uint64_t seed, bool keep_searching, const Sinks& sinks);

 private:
  /// Which view triangles are worth a way: those of the thesis, then those that show what these left out, then, when
  /// all was seen and still something is to be found, all of them again.
  enum class Looking { kCoarsely, kFinely, kAgain };

  // The thesis' loop: explore -> compare -> merge -> plan -> drive and look -> segment.
  void take_stock() override { compare(); }
  std::vector<Visit> open_visits() override;
  bool add_view_triangles() override;
  Progress arrived(const Visit& visit) override;
  Progress failed(const Visit& visit, const std::string& why) override;
  bool replan_due() override { return compare_due(); }
  bool is_pointless(const Visit& visit) override;
  void recovered() override { forget_failures(); }

  Progress explore(const Visit& visit);
  Progress examine(const Visit& visit);
  bool compare();                    // with the reference; did the regions change?
  [[nodiscard]] bool compare_due();  // the same, not more often than wanted
  std::optional<Visit> viewpoint_of(const knowledge::Region& region, const motion::PathLengths& ways);
  [[nodiscard]] bool is_covered(const view::ViewTriangle& view);
  std::vector<view::ViewTriangle> sample_view_triangles();
  void forget_failures();  // what was in the way of a region may be gone

  Looking looking_ = Looking::kCoarsely;
  change::Differencer differencer_;
  view::Head head_;
  std::map<int, std::vector<Pose2<Map, Base>>> tried_viewpoints_;  // by region, those that failed
  std::map<int, robot::HeadState> gaze_;                           // by region, for its current viewpoint
  std::set<int> given_up_;                                         // regions without a viewpoint that works
  Stamp next_comparison_;
};

}  // namespace amiss::mission
