#include "plan/problem_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/result.hpp"

namespace amiss::plan {
namespace {

const std::string& checked(const std::string& name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_allowed = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_'; };
  if (name.empty() || !is_letter(name[0]) || !std::all_of(name.begin(), name.end(), is_allowed)) {
    throw ArgumentError("'" + name + "' is no PDDL name; allowed are letters, digits, '-' and '_', a letter first");
  }
  return name;
}

std::string number_text(double value) {
  if (!std::isfinite(value) || value < 0) throw ArgumentError("a cost must be finite and not negative");
  char digits[400];
  const char* const end = std::to_chars(digits, digits + sizeof(digits), value, std::chars_format::fixed).ptr;
  return {static_cast<const char*>(digits), end};
}

std::string list_text(const std::string& head, const std::vector<std::string>& arguments) {
  std::string text = "(" + checked(head);
  for (const std::string& argument : arguments) text += " " + checked(argument);
  return text + ")";
}

}  // namespace

std::string to_pddl(const ProblemText& problem) {
  std::string text = "(define (problem " + checked(problem.name) + ")\n  (:domain " + checked(problem.domain) + ")\n";
  text += "  (:objects\n";
  for (const auto& object : problem.objects)
    text += "    " + checked(object.name) + " - " + checked(object.type) + "\n";
  text += "  )\n  (:init\n";
  if (problem.minimize_cost) text += "    (= (total-cost) 0)\n";
  for (const auto& fact : problem.init) text += "    " + list_text(fact.predicate, fact.arguments) + "\n";
  for (const auto& value : problem.values) {
    text += "    (= " + list_text(value.function, value.arguments) + " " + number_text(value.value) + ")\n";
  }
  text += "  )\n  (:goal (and\n";
  for (const auto& fact : problem.goal) text += "    " + list_text(fact.predicate, fact.arguments) + "\n";
  text += "  ))\n";
  if (problem.minimize_cost) text += "  (:metric minimize (total-cost))\n";
  return text + ")\n";
}

}  // namespace amiss::plan
