#include "mission/visit_plan.hpp"

#include <cmath>
#include <map>
#include <optional>

#include "motion/tour.hpp"
#include "plan/planner.hpp"
#include "plan/problem_text.hpp"
#include "plan/validator.hpp"

namespace amiss::mission {

namespace {

const std::string kRobot = "hsr";
const std::string kHere = "here";

/// What is seen from the place: a view triangle or a region.
std::string target_name(const Visit& visit) {
  return (visit.kind == Visit::Kind::kExplore ? "triangle" : "region") + std::to_string(visit.id);
}

std::string waypoint_name(const Visit& visit) {
  return (visit.kind == Visit::Kind::kExplore ? "view" : "viewpoint") + std::to_string(visit.id);
}

/// Names of places (0 is here) and the way lengths between them.
struct Places {
  std::vector<std::string> names;
  std::span<const double> lengths_m;
  std::size_t stride;

  [[nodiscard]] double length(std::size_t from, std::size_t to) const { return lengths_m[from * stride + to]; }
};

plan::ProblemText compose(std::span<const Visit> visits, const std::vector<std::size_t>& reachable,
                          const Places& places) {
  plan::ProblemText text;
  text.name = "visits";
  text.domain = "search";
  text.minimize_cost = true;
  text.objects = {{kRobot, "robot"}, {kHere, "waypoint"}};
  text.init = {{"robot_at", {kRobot, kHere}}};
  std::vector<std::size_t> nodes{0};
  for (const std::size_t place : reachable) {
    const Visit& visit = visits[place - 1];
    const std::string& waypoint = places.names[place];
    nodes.push_back(place);
    text.objects.push_back({waypoint, "waypoint"});
    if (visit.kind == Visit::Kind::kExplore) {
      text.objects.push_back({target_name(visit), "triangle"});
      text.init.push_back({"views", {waypoint, target_name(visit)}});
      text.goal.push_back({"explored", {target_name(visit)}});
    } else {
      text.objects.push_back({target_name(visit), "region"});
      text.init.push_back({"viewpoint", {waypoint, target_name(visit)}});
      text.goal.push_back({"examined", {target_name(visit)}});
    }
  }
  for (const std::size_t from : nodes) {
    for (const std::size_t to : nodes) {
      if (from == to || to == 0 || !std::isfinite(places.length(from, to))) continue;
      text.init.push_back({"connected", {places.names[from], places.names[to]}});
      text.values.push_back(
          {"distance", {places.names[from], places.names[to]}, std::round(100.0 * places.length(from, to))});
    }
  }
  return text;
}

/// The planner's plan says what has to be done at each place; here the places are put into the order of the tour, and
/// the ways between them follow.
plan::Plan in_tour_order(const plan::Plan& plan, const std::vector<std::size_t>& order, const Places& places) {
  std::map<std::string, std::vector<plan::Step>> work;  // by waypoint
  for (const plan::Step& step : plan.steps) {
    if (step.action != "goto_waypoint") work[step.arguments.at(1)].push_back(step);
  }
  plan::Plan ordered;
  std::string at = kHere;
  for (const std::size_t place : order) {
    const std::string& waypoint = places.names[place];
    ordered.steps.push_back({"goto_waypoint", {kRobot, at, waypoint}});
    for (const plan::Step& step : work[waypoint]) ordered.steps.push_back(step);
    at = waypoint;
  }
  return ordered;
}

std::vector<PlannedStep> steps_of(const plan::Plan& plan, std::span<const Visit> visits) {
  std::map<std::string, const Visit*> by_waypoint;
  for (const Visit& visit : visits) by_waypoint[waypoint_name(visit)] = &visit;
  std::vector<PlannedStep> steps;
  for (const plan::Step& step : plan.steps) {
    if (step.action == "goto_waypoint") {
      steps.push_back({PlannedStep::Action::kGoto, *by_waypoint.at(step.arguments.at(2))});
    } else {
      const auto action =
          step.action == "explore_waypoint" ? PlannedStep::Action::kExplore : PlannedStep::Action::kExamine;
      steps.push_back({action, *by_waypoint.at(step.arguments.at(1))});
    }
  }
  return steps;
}

}  // namespace

Result<VisitPlan> plan_visits(const plan::Domain& domain, std::span<const Visit> visits,
                              std::span<const double> lengths_m) {
  using Failure = Result<VisitPlan>;
  Places places{{kHere}, lengths_m, visits.size() + 1};
  for (const Visit& visit : visits) places.names.push_back(waypoint_name(visit));
  const motion::Tour tour = motion::shortest_tour(lengths_m, places.stride);
  if (tour.reachable == 0) return Failure::failure("no place can be reached");
  const std::vector<std::size_t> order(tour.order.begin(),
                                       tour.order.begin() + static_cast<std::ptrdiff_t>(tour.reachable));

  VisitPlan result;
  result.problem_pddl = plan::to_pddl(compose(visits, order, places));
  const plan::Problem problem = plan::parse_problem(result.problem_pddl, domain, "problem of the search");
  const auto solution = plan::solve(domain, problem);
  if (!solution) return Failure::failure(solution.why().sentence);
  result.plan = in_tour_order(solution->plan, order, places);
  const auto valid = plan::validate(domain, problem, result.plan);
  if (!valid) return Failure::failure(valid.why().sentence);
  result.plan.cost = *valid;
  result.steps = steps_of(result.plan, visits);
  return result;
}

}  // namespace amiss::mission
