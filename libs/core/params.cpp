#include "core/params.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "core/files.hpp"
#include "core/result.hpp"

namespace amiss {

namespace {

/// The shortest text that reads back as the same number.
std::string text_of(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

template <class T>
bool parse_number(std::string_view text, T& value) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// 58 degrees are stored in radians and printed as 58 again.
std::string degrees_text(double radians) {
  const double exact = radians * 180.0 / std::numbers::pi;
  const double rounded = std::round(exact * 1e9) / 1e9;
  return text_of(rounded);
}

std::string range_text(const std::string& low, const std::string& high, const std::string& unit) {
  return low + " .. " + high + (unit.empty() || unit == "1" ? "" : " " + unit);
}

/// The leaves of nested maps, each key once; errors name file:line.
class LeafReader {
 public:
  using Setter = std::function<void(const std::string& key, const std::string& text, const std::string& where)>;
  LeafReader(std::string file, Setter set) : file_(std::move(file)), set_(std::move(set)) {}

  void read(const YAML::Node& node, const std::string& prefix = "", int depth = 0) {
    constexpr int kDeepest = 8;  // an alias may make a map that holds itself
    for (const auto& entry : node) {
      const std::string where = file_ + ":" + std::to_string(entry.first.Mark().line + 1);
      if (!entry.first.IsScalar()) throw ArgumentError(where + ": the name of a parameter is needed as key");
      const std::string key = prefix + entry.first.Scalar();
      if (entry.second.IsMap() && depth < kDeepest) {
        read(entry.second, key + ".", depth + 1);
      } else if (entry.second.IsScalar()) {
        if (!seen_.insert(key).second) throw ArgumentError(where + ": " + key + " is set twice; once is allowed");
        set_(key, entry.second.Scalar(), where);
      } else {
        throw ArgumentError(where + ": " + key + " is empty, a list or nested too deeply; a single value is allowed");
      }
    }
  }

 private:
  std::string file_;
  Setter set_;
  std::set<std::string> seen_;
};

}  // namespace

void ParamTable::number(std::string key, double& value, std::string unit, double low, double high,
                        std::string meaning) {
  const bool in_degrees = unit == "deg";
  const double scale = in_degrees ? std::numbers::pi / 180.0 : 1.0;
  auto print = [&value, in_degrees] { return in_degrees ? degrees_text(value) : text_of(value); };
  auto parse = [&value, scale, low, high](std::string_view text) {
    double read = 0.0;
    if (!parse_number(text, read) || !(read >= low && read <= high)) return false;
    value = read * scale;
    return true;
  };
  rows_.push_back({std::move(key), unit, range_text(text_of(low), text_of(high), unit), std::move(meaning),
                   std::move(print), std::move(parse)});
}

void ParamTable::integer(std::string key, int& value, int low, int high, std::string meaning) {
  auto parse = [&value, low, high](std::string_view text) {
    int read = 0;
    if (!parse_number(text, read) || read < low || read > high) return false;
    value = read;
    return true;
  };
  rows_.push_back({std::move(key), "", "whole numbers " + range_text(std::to_string(low), std::to_string(high), ""),
                   std::move(meaning), [&value] { return std::to_string(value); }, std::move(parse)});
}

void ParamTable::flag(std::string key, bool& value, std::string meaning) {
  auto parse = [&value](std::string_view text) {
    if (text != "true" && text != "false") return false;
    value = text == "true";
    return true;
  };
  rows_.push_back({std::move(key), "", "true, false", std::move(meaning),
                   [&value] { return std::string(value ? "true" : "false"); }, std::move(parse)});
}

void ParamTable::choice(std::string key, std::string& value, std::vector<std::string> allowed, std::string meaning) {
  std::string listed;
  for (const std::string& word : allowed) listed += (listed.empty() ? "" : ", ") + word;
  auto parse = [&value, allowed = std::move(allowed)](std::string_view text) {
    if (std::find(allowed.begin(), allowed.end(), text) == allowed.end()) return false;
    value = std::string(text);
    return true;
  };
  rows_.push_back({std::move(key), "", listed, std::move(meaning), [&value] { return value; }, std::move(parse)});
}

void ParamTable::set(std::string_view key, std::string_view text, std::string_view where) {
  const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.key == key; });
  if (row == rows_.end()) {
    std::vector<std::string> keys;
    for (const Row& r : rows_) keys.push_back(r.key);
    const std::string near = nearest_word(key, keys);
    throw ArgumentError(std::string(where) + ": there is no parameter '" + std::string(key) + "'" +
                        (near.empty() ? "; --print-params lists them" : "; did you mean '" + near + "'?"));
  }
  if (!row->parse(text)) {
    throw ArgumentError(std::string(where) + ": " + row->key + " = '" + std::string(text) +
                        "' is not allowed; allowed: " + row->allowed);
  }
}

void ParamTable::set_override(std::string_view assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos) {
    throw ArgumentError("--set " + std::string(assignment) + ": a key=value is needed");
  }
  set(assignment.substr(0, equals), assignment.substr(equals + 1), "--set");
}

void ParamTable::load_file(const std::filesystem::path& file) {
  const std::string bytes = load_bytes(file, std::size_t{1} << 20U);
  try {
    const YAML::Node root = YAML::Load(bytes);
    if (root.IsNull()) return;
    if (!root.IsMap())
      throw ArgumentError(file.string() + ":1: keys and values are needed, as in 'view: {samples: 500}'");
    LeafReader(file.string(), [this](const auto& key, const auto& text, const auto& where) {
      set(key, text, where);
    }).read(root);
  } catch (const YAML::Exception& e) {
    throw ArgumentError(file.string() + ":" + std::to_string(e.mark.line + 1) + ": is not YAML: " + e.msg);
  }
}

std::string ParamTable::to_yaml() const {
  std::vector<const Row*> sorted;
  for (const Row& row : rows_) sorted.push_back(&row);
  std::sort(sorted.begin(), sorted.end(), [](const Row* a, const Row* b) { return a->key < b->key; });
  std::string yaml, group;
  for (const Row* row : sorted) {
    const auto dot = row->key.find('.');
    const std::string own_group = row->key.substr(0, dot);
    if (own_group != group) yaml += own_group + ":\n";
    group = own_group;
    yaml += "  " + row->key.substr(dot + 1) + ": " + row->print() + "  # [" + row->allowed + "] " + row->meaning + "\n";
  }
  return yaml;
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
  std::string nearest;
  std::size_t best = word.size() / 2 + 1;
  for (const std::string& candidate : candidates) {
    std::vector<std::size_t> row(candidate.size() + 1);  // Levenshtein distance, one row at a time
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < word.size(); ++i) {
      std::size_t diagonal = row[0];
      row[0] = i + 1;
      for (std::size_t j = 0; j < candidate.size(); ++j) {
        const std::size_t replaced = diagonal + (word[i] == candidate[j] ? 0U : 1U);
        diagonal = row[j + 1];
        row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
      }
    }
    if (row.back() < best) {
      best = row.back();
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace amiss
