#include "core/yaml_checks.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/files.hpp"
#include "core/params.hpp"
#include "core/result.hpp"

namespace amiss {
namespace {

constexpr std::size_t kMaxBytes = 1U << 20U;
constexpr double kFarthest = 1000.0;

std::string place(const std::filesystem::path& file, const YAML::Mark& mark) {
  return file.string() + ":" + std::to_string(std::max(0, mark.line) + 1) + ": ";
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

YAML::Node load_yaml(const std::filesystem::path& file) {
  try {
    return YAML::Load(load_bytes(file, kMaxBytes));
  } catch (const YAML::Exception& error) {
    throw InputError(place(file, error.mark) + "not YAML: " + error.msg);
  }
}

std::string yaml_place(const std::filesystem::path& file, const YAML::Node& node) { return place(file, node.Mark()); }

void check_yaml_keys(const std::filesystem::path& file, const YAML::Node& item, const std::vector<std::string>& known,
                     const std::vector<std::string>& needed, std::string_view example) {
  if (!item.IsMap()) throw InputError(yaml_place(file, item) + "not a map; allowed is " + std::string(example));
  for (const auto& pair : item) {
    const std::string key = pair.first.IsScalar() ? pair.first.Scalar() : "?";
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string nearest = nearest_word(key, known);
    throw InputError(yaml_place(file, pair.first) + "unknown key '" + key + "'" +
                     (nearest.empty() ? "" : "; did you mean '" + nearest + "'?") + " Allowed: " + listed(known));
  }
  for (const std::string& key : needed) {
    if (!item[key]) throw InputError(yaml_place(file, item) + key + " is missing; a number is needed");
  }
}

double yaml_number(const std::filesystem::path& file, const YAML::Node& item, const std::string& key, double fallback) {
  const YAML::Node node = item[key];
  if (!node) return fallback;
  double value = 0.0;
  const bool is_number = node.IsScalar() && YAML::convert<double>::decode(node, value) && std::isfinite(value);
  if (!is_number || std::abs(value) > kFarthest) {
    throw InputError(yaml_place(file, node) + key + " is not a number from -1000 to 1000");
  }
  return value;
}

std::string yaml_text(const std::filesystem::path& file, const YAML::Node& item, const std::string& key) {
  const YAML::Node node = item[key];
  if (node && node.IsScalar() && !node.Scalar().empty()) return node.Scalar();
  throw InputError(yaml_place(file, node ? node : item) + key + " is missing or empty; a name is needed");
}

std::string yaml_exact(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string yaml_quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + "'";
}

}  // namespace amiss
