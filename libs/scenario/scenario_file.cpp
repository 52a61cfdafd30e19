#include "scenario/scenario_file.hpp"

#include <algorithm>

#include "core/files.hpp"
#include "core/result.hpp"
#include "scenario/internal/event_reader.hpp"

namespace amiss::scenario {

namespace {

using internal::YamlReader;

constexpr std::size_t kMaxBytes = 1U << 20U;

/// Nested maps or dotted keys.
void read_settings(const YamlReader& map, const std::string& prefix, std::vector<Setting>& settings) {
  constexpr std::ptrdiff_t kDeepest = 8;  // an alias may make a map that holds itself
  if (std::count(prefix.begin(), prefix.end(), '.') > kDeepest) map.fail("too many levels");
  map.each([&](const std::string& key, const YamlReader& value) {
    if (value.is_map()) {
      read_settings(value, prefix + key + ".", settings);
    } else {
      settings.push_back({prefix + key, value.text(), value.where()});
    }
  });
}

std::vector<Setting> read_settings(const YamlReader& root, const std::string& key) {
  std::vector<Setting> settings;
  if (const auto params = root.find(key)) read_settings(*params, "", settings);
  return settings;
}

score::Limits read_limits(const YamlReader& value) {
  constexpr double kLargest = 1e9;
  if (!value.is_map()) {
    const double number = value.number(-kLargest, kLargest);
    return {number, number};
  }
  value.allow({"min", "max"});
  score::Limits limits;
  if (const auto least = value.find("min")) limits.least = least->number(-kLargest, kLargest);
  if (const auto most = value.find("max")) limits.most = most->number(-kLargest, kLargest);
  return limits;
}

score::Expectations read_expectations(const YamlReader& map) {
  std::vector<std::string> keys{"found",    "not_found", "detected",    "not_detected", "found_by",
                                "category", "end",       "exit_status", "why",          "navigation_errors"};
  std::vector<std::string> numbers;
  for (const score::NumberRow& row : score::number_rows()) numbers.emplace_back(row.name);
  keys.insert(keys.end(), numbers.begin(), numbers.end());
  map.allow(keys);

  score::Expectations expect;
  const auto words = [&](const char* key) {
    const auto value = map.find(key);
    return value ? value->words() : std::vector<std::string>{};
  };
  expect.found = words("found");
  expect.not_found = words("not_found");
  expect.detected = words("detected");
  expect.not_detected = words("not_detected");
  const auto choices = [&](const char* key, const std::vector<std::string>& allowed, const char* of_what) {
    const auto value = map.find(key);
    if (!value) return std::vector<std::string>{};
    std::vector<std::string> chosen;
    for (const YamlReader& word : value->is_list() ? value->items() : std::vector{*value}) {
      chosen.push_back(word.choice(allowed, of_what));
    }
    return chosen;
  };
  expect.end = choices("end", score::end_words(), "end of a run");
  expect.why = choices("why", score::why_words(), "trouble");
  if (const auto errors = map.find("navigation_errors")) {
    errors->allow(score::navigation_error_words());
    errors->each([&](const std::string& error, const YamlReader& limits) {
      expect.navigation_errors[error] = read_limits(limits);
    });
  }
  if (const auto times = map.find("found_by")) {
    times->each(
        [&](const std::string& object, const YamlReader& by) { expect.found_by_s[object] = by.number(0.0, 1e6); });
  }
  if (const auto categories = map.find("category")) {
    categories->each([&](const std::string& object, const YamlReader& category) {
      expect.category[object] = category.choice({"novel"}, "category");
    });
  }
  if (const auto status = map.find("exit_status")) expect.exit_status = static_cast<int>(status->number(0, 255));
  for (const std::string& number : numbers) {
    if (const auto limits = map.find(number)) expect.numbers[number] = read_limits(*limits);
  }
  return expect;
}

world::Script read_script(const YamlReader& root, const Vocabulary& vocabulary) {
  world::Script script;
  if (const auto objects = root.find("objects")) {
    for (const YamlReader& item : objects->items()) script.events.push_back(internal::read_object(item, vocabulary));
  }
  if (const auto events = root.find("events")) {
    for (const YamlReader& item : events->items()) script.events.push_back(internal::read_event(item, vocabulary));
  }
  internal::check(script, root);
  return script;
}

bool read_until(const YamlReader& word) { return word.choice({"found", "explored"}, "end") == "found"; }
double read_time_limit(const YamlReader& number) { return number.number(1.0, 1e5); }

Break read_break(const YamlReader& item, const Vocabulary& vocabulary) {
  item.allow({"why", "params", "objects", "events", "until", "time_limit", "fails"});
  Break how;
  how.why = item.text_or("why", "");
  how.params = read_settings(item, "params");
  if (item.find("objects") || item.find("events")) how.script = read_script(item, vocabulary);
  if (const auto until = item.find("until")) how.until_found = read_until(*until);
  if (const auto limit = item.find("time_limit")) how.time_limit_s = read_time_limit(*limit);
  if (const auto fails = item.find("fails")) how.fails = fails->words();
  return how;
}

/// What must be found must be put there by the script.
void check_names(const Scenario& scenario, const YamlReader& root) {
  const std::vector<std::string> all = names_of(scenario.script);
  const auto check = [&](const std::string& name) {
    if (std::find(all.begin(), all.end(), name) != all.end()) return;
    root.at("expect").fail("'" + name + "' is expected, but nothing adds it");
  };
  const score::Expectations& expect = scenario.expect;
  for (const auto* names : {&expect.found, &expect.not_found, &expect.detected, &expect.not_detected}) {
    for (const std::string& name : *names) check(name);
  }
  for (const auto& [name, by_s] : expect.found_by_s) check(name);
  for (const auto& [name, category] : expect.category) check(name);
}

/// What a break makes fail must be expected.
void check_fails(const YamlReader& item, const YamlReader& expect) {
  const auto fails = item.find("fails");
  if (!fails) return;
  for (const YamlReader& word : fails->is_list() ? fails->items() : std::vector{*fails}) {
    const std::string key = word.text();
    if (key == "events" || expect.find(key)) continue;
    std::string allowed;
    expect.each([&](const std::string& given, const YamlReader&) { allowed += given + ", "; });
    word.fail("'" + key + "' should fail, but is not expected; Allowed: " + allowed + "events");
  }
}

Scenario read_scenario(const YamlReader& root, const std::filesystem::path& file, const Vocabulary& vocabulary) {
  root.allow({"about", "world", "seed", "until", "time_limit", "start", "params", "reference_params", "objects",
              "events", "expect", "breaks"});
  Scenario scenario;
  scenario.file = file;
  scenario.name = file.stem().string();
  scenario.about = root.text_or("about", "");
  scenario.world = root.at("world").text();
  if (const std::filesystem::path beside = file.parent_path() / scenario.world; std::filesystem::exists(beside)) {
    scenario.world = beside.string();
  }
  scenario.seed = static_cast<std::uint64_t>(root.number_or("seed", 1.0, 0.0, 1e15));
  if (const auto until = root.find("until")) scenario.until_found = read_until(*until);
  if (const auto limit = root.find("time_limit")) scenario.time_limit_s = read_time_limit(*limit);
  if (const auto start = root.find("start")) scenario.start = internal::read_pose(*start);
  scenario.params = read_settings(root, "params");
  scenario.reference_params = read_settings(root, "reference_params");
  scenario.script = read_script(root, vocabulary);
  scenario.expect = read_expectations(root.at("expect"));
  if (scenario.until_found && scenario.expect.found.empty()) {
    root.at("expect").fail("'until: found' needs 'found', the objects to be found");
  }
  check_names(scenario, root);
  if (const auto breaks = root.find("breaks")) {
    for (const YamlReader& item : breaks->items()) {
      scenario.breaks.push_back(read_break(item, vocabulary));
      check_fails(item, root.at("expect"));
    }
  }
  return scenario;
}

}  // namespace

Scenario parse_scenario(const std::string& text, const std::filesystem::path& file, const Vocabulary& vocabulary) {
  try {
    return read_scenario(YamlReader(file.string(), YAML::Load(text)), file, vocabulary);
  } catch (const YAML::Exception& error) {
    throw InputError(file.string() + ":" + std::to_string(std::max(0, error.mark.line) + 1) + ":" +
                     std::to_string(std::max(0, error.mark.column) + 1) + ": not YAML: " + error.msg);
  }
}

Scenario load_scenario(const std::filesystem::path& file, const Vocabulary& vocabulary) {
  return parse_scenario(load_bytes(file, kMaxBytes), file, vocabulary);
}

void save_scenario(const std::filesystem::path& file, const Scenario& scenario, const Vocabulary& vocabulary) {
  save_atomically(file, to_yaml(scenario, vocabulary));
}

}  // namespace amiss::scenario
