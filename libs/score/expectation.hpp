// What a run is expected to show, and whether it did. Expectations + RunRecord -> findings, one for each expectation.
// Numbers are named by number_rows(); a limit that is not given is open. Judged after the run: nothing here reaches the
// robot.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace amiss::score {

struct Limits {
  std::optional<double> least, most;
};

struct Expectations {
  std::vector<std::string> found, not_found;        // objects
  std::vector<std::string> detected, not_detected;  // objects that have a region, or never had one
  std::map<std::string, double> found_by_s;         // by object
  std::map<std::string, std::string> category;      // by object
  std::vector<std::string> end;                     // how the run may end
  std::vector<std::string> why;                     // and what trouble may have ended it
  std::map<std::string, Limits> navigation_errors;  // how often which, by word
  std::optional<int> exit_status;
  std::map<std::string, Limits> numbers;
};

/// What a run showed, by the words of the expectations.
struct RunRecord {
  std::string end, why;
  int exit_status = 0;
  std::map<std::string, int> navigation_errors;
  std::map<std::string, double> found_at_s;
  std::set<std::string> detected;
  std::map<std::string, std::string> category;  // only where the method gives one
  std::map<std::string, double> numbers;
  std::vector<std::string> not_happened;  // events whose moment never came
};

struct Finding {
  std::string what;  // the expectation's key
  bool holds = false;
  std::string sentence;  // what was expected and what came
};

/// In the order of the members above; that all events happened is always expected, as "events".
[[nodiscard]] std::vector<Finding> judge(const Expectations& expected, const RunRecord& run);

struct NumberRow {
  std::string_view name, unit, meaning;
};
[[nodiscard]] const std::vector<NumberRow>& number_rows();
/// The words for `end`, `why` and `navigation_errors`.
[[nodiscard]] const std::vector<std::string>& end_words();
[[nodiscard]] const std::vector<std::string>& why_words();
[[nodiscard]] const std::vector<std::string>& navigation_error_words();

}  // namespace amiss::score
