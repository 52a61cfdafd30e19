// A plan, and its file: one "(action object ...)" a line, as the planning competitions and VAL write it.
//
// Read as well: "0.000: (action object ...) [1.0]" (ROSPlan, POPF), step numbers, any case, ';' comments, blank lines.
// Errors: InputError naming file and line. Thesis 4.2.3.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace amiss::plan {

struct Step {
  std::string action;
  std::vector<std::string> arguments;
  bool operator==(const Step&) const = default;
};

struct Plan {
  std::vector<Step> steps;
  double cost = 0;  // sum of the actions' costs; the number of steps where the problem has no cost metric
};

/// "(goto_waypoint hsr wp1 wp2)"
[[nodiscard]] std::string to_string(const Step& step);
/// One step a line, then "; cost = ...".
[[nodiscard]] std::string to_string(const Plan& plan);
/// Cost is not read from text: it is the number of steps until a validator has computed it.
[[nodiscard]] Plan parse_plan(std::string_view text, const std::string& name);
[[nodiscard]] Plan load_plan(const std::filesystem::path& file);
void save_plan(const std::filesystem::path& file, const Plan& plan);

}  // namespace amiss::plan
