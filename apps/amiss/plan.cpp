// amiss plan DOMAIN PROBLEM: solves, or checks a plan that somebody else made.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "plan/planner.hpp"
#include "plan/validator.hpp"

namespace amiss::app {
namespace {

struct Arguments {
  std::string domain, problem, plan;
  bool json = false;
};

void print(const nlohmann::json& report) {
  std::cout << report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

int check(const Arguments& arguments, const plan::Domain& domain, const plan::Problem& problem) {
  const plan::Plan plan = plan::load_plan(arguments.plan);
  const auto cost = plan::validate(domain, problem, plan);
  if (arguments.json) {
    nlohmann::json report = {{"outcome", cost ? "valid" : "invalid"}, {"steps", plan.steps.size()}};
    if (cost) report["cost"] = *cost;
    if (!cost && cost.why().step) report["step"] = *cost.why().step;
    if (!cost) report.update({{"literal", cost.why().literal}, {"reason", cost.why().sentence}});
    print(report);
  } else if (cost) {
    std::cout << "valid: " << plan.steps.size() << " steps, cost " << *cost << '\n';
  } else {
    std::cout << "invalid: " << cost.why().sentence << '\n';
  }
  return cost ? kGoalMet : kGoalNotMet;
}

nlohmann::json evidence(const plan::SearchCounts& counts) {
  return {{"ground_actions", counts.ground_actions},
          {"facts", counts.facts},
          {"evaluated_states", counts.evaluated_states},
          {"hill_climbing_sufficed", counts.hill_climbing_sufficed}};
}

int fail(const Arguments& arguments, const plan::NoPlan& none) {
  const bool is_unsolvable = none.reason == plan::NoPlan::Reason::kUnsolvable;
  if (arguments.json) {
    print({{"outcome", is_unsolvable ? "unsolvable" : "limit reached"},
           {"reason", none.sentence},
           {"search", evidence(none.counts)}});
  } else {
    std::cout << (is_unsolvable ? "unsolvable: " : "limit reached: ") << none.sentence << '\n';
  }
  return kGoalNotMet;
}

int find(const Arguments& arguments, const plan::Domain& domain, const plan::Problem& problem) {
  const auto solution = plan::solve(domain, problem);
  if (!solution) return fail(arguments, solution.why());
  if (const auto cost = plan::validate(domain, problem, solution->plan); !cost) {
    throw std::logic_error("the planner's own plan is wrong: " + cost.why().sentence);
  }
  if (arguments.json) {
    nlohmann::json steps = nlohmann::json::array();
    for (const plan::Step& step : solution->plan.steps) steps.push_back(plan::to_string(step));
    print({{"outcome", "solved"},
           {"plan", steps},
           {"cost", solution->plan.cost},
           {"search", evidence(solution->counts)}});
  } else {
    std::cout << plan::to_string(solution->plan);
  }
  return kGoalMet;
}

}  // namespace

void add_plan_command(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* const command = app.add_subcommand("plan", "Solve a PDDL problem, or validate a plan for it");
  command->add_option("DOMAIN", arguments->domain, "PDDL domain")->type_name("FILE")->required();
  command->add_option("PROBLEM", arguments->problem, "PDDL problem for that domain")->type_name("FILE")->required();
  command->add_option("--validate", arguments->plan, "check this plan instead of making one")->type_name("FILE");
  command->add_flag("--json", arguments->json, "print JSON on standard output");
  command->callback([arguments, &exit_status] {
    const plan::Domain domain = plan::load_domain(arguments->domain);
    const plan::Problem problem = plan::load_problem(arguments->problem, domain);
    exit_status = arguments->plan.empty() ? find(*arguments, domain, problem) : check(*arguments, domain, problem);
  });
}

}  // namespace amiss::app
