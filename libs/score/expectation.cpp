#include "score/expectation.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace amiss::score {

namespace {

std::string text_of(double value) {
  if (std::isinf(value)) return value > 0.0 ? "never" : "-inf";
  std::array<char, 32> text{};
  const double rounded = std::round(value * 1e4) / 1e4;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), rounded).ptr};
}

std::string list_of(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text.empty() ? "none" : text;
}

/// Collects the findings of one run.
struct Judge {
  const RunRecord& run;
  std::vector<Finding> findings;

  void add(const std::string& what, bool holds, std::string sentence) {
    findings.push_back({what, holds, std::move(sentence)});
  }
  void found(const std::string& object, bool wanted);
  void detected(const std::string& object, bool wanted);
  void found_by(const std::string& object, double by_s);
  void category(const std::string& object, const std::string& wanted);
  void number(const std::string& name, const Limits& limits);
  void value(const std::string& what, const std::string& name, double value, const Limits& limits);
};

void Judge::found(const std::string& object, bool wanted) {
  const auto at = run.found_at_s.find(object);
  const bool was = at != run.found_at_s.end();
  const std::string came = was ? object + " was found after " + text_of(at->second) + " s" : object + " was not found";
  add(wanted ? "found" : "not_found", was == wanted, came);
}

void Judge::detected(const std::string& object, bool wanted) {
  const bool was = run.detected.contains(object);
  add(wanted ? "detected" : "not_detected", was == wanted, object + (was ? " had a region" : " never had a region"));
}

void Judge::found_by(const std::string& object, double by_s) {
  const auto at = run.found_at_s.find(object);
  const bool was = at != run.found_at_s.end();
  add("found_by", was && at->second <= by_s,
      object + " by " + text_of(by_s) + " s: " + (was ? "found after " + text_of(at->second) + " s" : "not found"));
}

void Judge::category(const std::string& object, const std::string& wanted) {
  const auto given = run.category.find(object);
  const std::string came = given == run.category.end() ? "none" : given->second;
  add("category", came == wanted, object + " is " + wanted + ": it was given " + came);
}

void Judge::number(const std::string& name, const Limits& limits) {
  const auto given = run.numbers.find(name);
  if (given == run.numbers.end()) return add(name, false, name + " was not measured");
  value(name, name, given->second, limits);
}

void Judge::value(const std::string& what, const std::string& name, double value, const Limits& limits) {
  const bool holds =
      !std::isnan(value) && (!limits.least || value >= *limits.least) && (!limits.most || value <= *limits.most);
  std::string wanted;
  if (limits.least && limits.most == limits.least) {
    return add(what, holds, name + " exactly " + text_of(*limits.least) + ": it was " + text_of(value));
  }
  if (limits.least) wanted += " at least " + text_of(*limits.least);
  if (limits.most) wanted += std::string(limits.least ? " and" : "") + " at most " + text_of(*limits.most);
  add(what, holds, name + wanted + ": it was " + text_of(value));
}

}  // namespace

std::vector<Finding> judge(const Expectations& expected, const RunRecord& run) {
  Judge judge{run, {}};
  for (const std::string& object : expected.found) judge.found(object, true);
  for (const std::string& object : expected.not_found) judge.found(object, false);
  for (const std::string& object : expected.detected) judge.detected(object, true);
  for (const std::string& object : expected.not_detected) judge.detected(object, false);
  for (const auto& [object, by_s] : expected.found_by_s) judge.found_by(object, by_s);
  for (const auto& [object, category] : expected.category) judge.category(object, category);
  if (!expected.end.empty()) {
    const bool allowed = std::find(expected.end.begin(), expected.end.end(), run.end) != expected.end.end();
    judge.add("end", allowed, list_of(expected.end, " or ") + ": it ended with " + run.end);
  }
  if (!expected.why.empty()) {
    const bool allowed = std::find(expected.why.begin(), expected.why.end(), run.why) != expected.why.end();
    judge.add("why", allowed, list_of(expected.why, " or ") + ": it was " + (run.why.empty() ? "none" : run.why));
  }
  if (expected.exit_status) {
    judge.add("exit_status", run.exit_status == *expected.exit_status,
              std::to_string(*expected.exit_status) + ": it was " + std::to_string(run.exit_status));
  }
  for (const auto& [name, limits] : expected.navigation_errors) {
    const auto times = run.navigation_errors.find(name);
    const double value = times == run.navigation_errors.end() ? 0.0 : times->second;
    judge.value("navigation_errors", name, value, limits);
  }
  for (const auto& [name, limits] : expected.numbers) judge.number(name, limits);
  judge.add("events", run.not_happened.empty(),
            run.not_happened.empty() ? "all happened" : "never happened: " + list_of(run.not_happened, "; "));
  return std::move(judge.findings);
}

const std::vector<NumberRow>& number_rows() {
  static const std::vector<NumberRow> kRows{
      {"duration", "s", "simulated time until the run ended"},
      {"distance", "m", "driven, by the odometry"},
      {"coverage", "", "part of the reachable floor that was seen"},
      {"collisions", "", "touches of the robot with anything but the floor"},
      {"regions", "", "regions of interest, withdrawn ones included"},
      {"regions_false", "", "of these, where no object ever was"},
      {"regions_withdrawn", "", "of these, taken back because they were not confirmed"},
      {"regions_grown", "", "times that a region grew"},
      {"regions_reopened", "", "times that a region grew so much that it had to be examined again"},
      {"segmentations", "", "segmentation actions"},
      {"plans", "", "plans made"},
      {"failed_actions", "", "goals that were not reached"},
      {"view_triangles", "", "generated"},
      {"views_dropped", "", "view triangles that were not driven to, because their floor was seen on the way"},
      {"localization_error", "m", "of the position, at the end"},
      {"localization_error_max", "m", "of the position, largest"},
      {"recovery", "s", "from the last kidnapping or jump until the position is right by 0.15 m and stays so"},
  };
  return kRows;
}

const std::vector<std::string>& end_words() {
  static const std::vector<std::string> kWords{"found", "explored",    "time_limit", "gave_up",
                                               "lost",  "sensor_lost", "stopped"};
  return kWords;
}

const std::vector<std::string>& why_words() {
  static const std::vector<std::string> kWords{"camera silent",    "camera stuck", "camera garbage", "camera wrong",
                                               "laser silent",     "laser stuck",  "laser garbage",  "odometry silent",
                                               "odometry garbage", "pose lost"};
  return kWords;
}

const std::vector<std::string>& navigation_error_words() {
  static const std::vector<std::string> kWords{"no_path", "blocked", "off_path",   "held",
                                               "timeout", "lost",    "sensor_lost"};
  return kWords;
}

}  // namespace amiss::score
