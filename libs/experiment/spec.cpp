#include "experiment/spec.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "core/files.hpp"
#include "core/params.hpp"
#include "core/result.hpp"
#include "report/search_times.hpp"

namespace amiss::experiment {

namespace {

/// Values of one YAML file, with errors that name file and line.
class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {}

  [[noreturn]] void refuse(const YAML::Node& node, const std::string& what) const {
    throw ArgumentError(fmt::format("{}:{}: {}", file_, node.Mark().line + 1, what));
  }

  using Setters = std::map<std::string, std::function<void(const YAML::Node&)>>;
  /// Each key of the map once and known; those of `needed` must be there.
  void map(const YAML::Node& node, const Setters& setters, const std::set<std::string>& needed) const {
    if (!node.IsMap()) refuse(node, "a map of keys and values is needed");
    std::vector<std::string> known;
    for (const auto& [key, set] : setters) known.push_back(key);
    std::set<std::string> seen;
    for (const auto& entry : node) {
      const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
      const auto setter = setters.find(key);
      if (setter == setters.end()) {
        refuse(entry.first, fmt::format("there is no key '{}'; allowed: {}", key, fmt::join(known, ", ")));
      }
      if (!seen.insert(key).second) refuse(entry.first, key + " stands twice; once is allowed");
      setter->second(entry.second);
    }
    for (const std::string& key : needed) {
      if (!seen.contains(key)) refuse(node, key + " is missing");
    }
  }

  [[nodiscard]] std::string word(const YAML::Node& node) const {
    if (!node.IsScalar() || node.Scalar().empty()) refuse(node, "a word is needed");
    return node.Scalar();
  }
  [[nodiscard]] std::string one_of(const YAML::Node& node, const std::vector<std::string>& allowed) const {
    const std::string value = word(node);
    if (std::find(allowed.begin(), allowed.end(), value) == allowed.end()) {
      refuse(node, fmt::format("'{}' is not allowed; allowed: {}", value, fmt::join(allowed, ", ")));
    }
    return value;
  }
  template <class T>
  [[nodiscard]] T number(const YAML::Node& node, T low, T high) const {
    T value{};
    try {
      value = node.as<T>();
    } catch (const YAML::Exception&) {
      refuse(node, fmt::format("a number is needed; allowed: {} .. {}", low, high));
    }
    if (!(value >= low && value <= high))
      refuse(node, fmt::format("{} is not allowed; allowed: {} .. {}", value, low, high));
    return value;
  }
  /// Not empty, nothing twice.
  template <class Read>
  [[nodiscard]] auto list(const YAML::Node& node, const Read& read) const {
    if (!node.IsSequence() || node.size() == 0) refuse(node, "a list of one or more is needed");
    std::vector<decltype(read(node))> values;
    for (const auto& entry : node) {
      auto value = read(entry);
      if (std::find(values.begin(), values.end(), value) != values.end())
        refuse(entry, "stands twice; once is allowed");
      values.push_back(std::move(value));
    }
    return values;
  }

 private:
  std::string file_;
};

const std::vector<std::string> kShown{"segmentations", "time", "found"};

FigureSpec figure_of(const Reader& reader, const YAML::Node& node, const Spec& spec) {
  std::vector<std::string> times;
  for (const report::SegmentationTimes& t : report::kSegmentationTimes) times.emplace_back(t.name);
  FigureSpec figure;
  reader.map(node,
             {{"name",
               [&](const YAML::Node& n) {
                 figure.name = reader.word(n);
                 const auto plain = [](char c) {
                   return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
                 };
                 if (!std::all_of(figure.name.begin(), figure.name.end(), plain)) {
                   reader.refuse(n, "letters, digits, _ and - are allowed in the name of a figure");
                 }
               }},
              {"title", [&](const YAML::Node& n) { figure.title = reader.word(n); }},
              {"world", [&](const YAML::Node& n) { figure.world = reader.one_of(n, spec.worlds); }},
              {"shows",
               [&](const YAML::Node& n) {
                 const std::string shown = reader.one_of(n, kShown);
                 figure.shows = FigureSpec::Shows(std::find(kShown.begin(), kShown.end(), shown) - kShown.begin());
               }},
              {"times",
               [&](const YAML::Node& n) {
                 figure.times = reader.list(n, [&](const YAML::Node& t) { return reader.one_of(t, times); });
               }}},
             {"name", "title", "world", "shows"});
  if (figure.shows != FigureSpec::Shows::kSegmentations && figure.times.empty()) {
    reader.refuse(node, "times is missing: with which segmentation times the figure is drawn");
  }
  return figure;
}

void read_params(const Reader& reader, const YAML::Node& node, Spec& spec) {
  if (!node.IsMap()) reader.refuse(node, "a map of parameters and values is needed, such as search.compare: 0.5");
  for (const auto& entry : node) spec.params.emplace_back(reader.word(entry.first), reader.word(entry.second));
  std::sort(spec.params.begin(), spec.params.end());
}

Spec spec_of(const Reader& reader, const YAML::Node& node) {
  constexpr std::uint64_t kLargestSeed = 1'000'000'000;
  Spec spec;
  YAML::Node figures;
  const auto words = [&](const YAML::Node& n) { return reader.word(n); };
  const auto count = [&](const YAML::Node& n) { return reader.number(n, 1, 100); };
  const std::vector<std::string> methods{std::string(report::kDynamic), std::string(report::kStatic)};
  const auto method = [&](const YAML::Node& n) { return reader.one_of(n, methods); };
  const auto seed = [&](const YAML::Node& n) { return reader.number<std::uint64_t>(n, 0, kLargestSeed); };
  reader.map(node,
             {{"name", [&](const YAML::Node& n) { spec.name = reader.word(n); }},
              {"worlds", [&](const YAML::Node& n) { spec.worlds = reader.list(n, words); }},
              {"methods", [&](const YAML::Node& n) { spec.methods = reader.list(n, method); }},
              {"objects", [&](const YAML::Node& n) { spec.objects = reader.list(n, count); }},
              {"runs", [&](const YAML::Node& n) { spec.runs = reader.number(n, 1, 100000); }},
              {"first_seed", [&](const YAML::Node& n) { spec.first_seed = seed(n); }},
              {"scatter_seed", [&](const YAML::Node& n) { spec.scatter_seed = seed(n); }},
              {"time_limit", [&](const YAML::Node& n) { spec.time_limit_s = reader.number(n, 1.0, 1e6); }},
              {"trial_wall", [&](const YAML::Node& n) { spec.trial_wall_s = reader.number(n, 0.1, 1e6); }},
              {"params", [&](const YAML::Node& n) { read_params(reader, n, spec); }},
              {"figures", [&](const YAML::Node& n) { figures = n; }}},
             {"name", "worlds", "methods", "objects", "runs"});
  if (figures.IsDefined() && !figures.IsNull()) {
    std::set<std::string> names;
    for (const auto& figure : figures) {
      spec.figures.push_back(figure_of(reader, figure, spec));
      if (!names.insert(spec.figures.back().name).second) reader.refuse(figure, "two figures have this name");
    }
  }
  return spec;
}

}  // namespace

Spec load_spec(const std::filesystem::path& file) {
  constexpr std::size_t kLargest = 1 << 20;
  YAML::Node node;
  try {
    node = YAML::Load(load_bytes(file, kLargest));
  } catch (const YAML::Exception& e) {
    throw ArgumentError(fmt::format("{}:{}: is no YAML ({})", file.string(), e.mark.line + 1, e.msg));
  }
  return spec_of(Reader(file.string()), node);
}

}  // namespace amiss::experiment
