// Composes the planning problem of a search, has it solved, puts the visits into the order of the shortest tour and
// proves the result valid (thesis 4.2.3, 4.3.2).
// Places to explore or examine + way lengths between them -> a validated plan in the domain share/pddl/search.pddl.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/frames.hpp"
#include "core/result.hpp"
#include "plan/domain.hpp"
#include "plan/plan.hpp"

namespace amiss::mission {

/// Something to be done at a place: explore a view triangle, or examine a region.
struct Visit {
  enum class Kind { kExplore, kExamine };
  Kind kind = Kind::kExplore;
  int id = 0;  // of the view triangle or region in the knowledge base
  Pose2<Map, Base> T_map_base;
  bool operator==(const Visit& other) const { return kind == other.kind && id == other.id; }
};

/// A step of a plan and the visit that it belongs to.
struct PlannedStep {
  enum class Action { kGoto, kExplore, kExamine };
  Action action = Action::kGoto;
  Visit visit;
};

struct VisitPlan {
  std::vector<PlannedStep> steps;
  std::string problem_pddl;
  plan::Plan plan;
};

/// `lengths_m`: row-major (n+1) x (n+1) way lengths, place 0 is where the robot stands, place i+1 is visits[i];
/// infinite where there is no way: such visits are left out. The failure says why there is no plan.
[[nodiscard]] Result<VisitPlan> plan_visits(const plan::Domain& domain, std::span<const Visit> visits,
                                            std::span<const double> lengths_m);

}  // namespace amiss::mission
