#include "plan/plan.hpp"

#include <charconv>

#include "core/files.hpp"
#include "core/result.hpp"
#include "plan/internal/sexpr.hpp"

namespace amiss::plan {
namespace {

std::string_view trim(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\f\v";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

/// "0.000:" or "12:", as planners put before a step.
bool is_time_stamp(std::string_view text) {
  if (!text.ends_with(':')) return false;
  text = trim(text.substr(0, text.size() - 1));
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && rest == text.data() + text.size();
}

/// "[1.000]", the duration or cost after a step.
bool is_duration(std::string_view text) { return text.starts_with('[') && text.ends_with(']'); }

Step parse_step(std::string_view line, const Source& source, int number) {
  const std::size_t open = line.find('(');
  const std::size_t close = line.rfind(')');
  const auto fail = [&] {
    source.fail(number, "'" + std::string(line.substr(0, 60)) +
                            "' is no step; allowed are '(action object ...)' and '0.000: (action object ...) [1.0]'");
  };
  if (open == std::string_view::npos || close == std::string_view::npos || close < open) fail();
  const std::string_view before = trim(line.substr(0, open));
  const std::string_view after = trim(line.substr(close + 1));
  if ((!before.empty() && !is_time_stamp(before)) || (!after.empty() && !is_duration(after))) fail();

  const Sexpr list = parse_sexpr(line.substr(open, close - open + 1), source, number);
  if (list.items.empty()) fail();
  Step step;
  for (const Sexpr& item : list.items) {
    if (item.is_list) fail();
    (step.action.empty() ? step.action : step.arguments.emplace_back()) = item.word;
  }
  return step;
}

}  // namespace

std::string to_string(const Step& step) {
  std::string text = "(" + step.action;
  for (const std::string& argument : step.arguments) text += " " + argument;
  return text + ")";
}

std::string to_string(const Plan& plan) {
  std::string text;
  for (const Step& step : plan.steps) text += to_string(step) + "\n";
  char digits[32];
  const char* const end = std::to_chars(digits, digits + sizeof(digits), plan.cost).ptr;
  return text + "; cost = " + std::string(static_cast<const char*>(digits), end) + "\n";
}

Plan parse_plan(std::string_view text, const std::string& name) {
  const Source source{name};
  Plan plan;
  int number = 1;
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    const std::string_view content = trim(line.substr(0, line.find(';')));
    if (!content.empty()) plan.steps.push_back(parse_step(content, source, number));
    begin = end + 1;
  }
  plan.cost = static_cast<double>(plan.steps.size());
  return plan;
}

Plan load_plan(const std::filesystem::path& file) { return parse_plan(load_bytes(file, kMaxFileBytes), file.string()); }

void save_plan(const std::filesystem::path& file, const Plan& plan) { save_atomically(file, to_string(plan)); }

}  // namespace amiss::plan
