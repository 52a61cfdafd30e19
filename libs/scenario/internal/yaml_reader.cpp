#include "scenario/internal/yaml_reader.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/params.hpp"
#include "core/result.hpp"

namespace amiss::scenario::internal {

namespace {

std::string listed(const std::vector<std::string>& words) {
  constexpr std::size_t kShown = 40;
  std::string text;
  for (std::size_t i = 0; i < std::min(words.size(), kShown); ++i) text += (i == 0 ? "" : ", ") + words[i];
  return text + (words.size() > kShown ? ", ..." : "");
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& allowed) {
  const std::string near = nearest_word(word, allowed);
  return (near.empty() ? "; " : "; did you mean '" + near + "'? ") + "Allowed: " + listed(allowed);
}

std::string short_number(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

std::string YamlReader::where() const {
  const YAML::Mark mark = node_.Mark();
  return file_ + ":" + std::to_string(std::max(0, mark.line) + 1) + ":" + std::to_string(std::max(0, mark.column) + 1);
}

void YamlReader::fail(const std::string& what) const { throw InputError(where() + ": " + what); }

void YamlReader::allow(const std::vector<std::string>& keys) const {
  if (!node_.IsMap()) fail("a map is needed, with the keys " + listed(keys));
  std::set<std::string> seen;
  for (const auto& pair : node_) {
    const YamlReader key(file_, pair.first);
    const std::string word = key.text();
    if (std::find(keys.begin(), keys.end(), word) == keys.end()) {
      key.fail("unknown key '" + word + "'" + did_you_mean(word, keys));
    }
    if (!seen.insert(word).second) key.fail("the key '" + word + "' is there twice");
  }
}

std::optional<YamlReader> YamlReader::find(const std::string& key) const {
  const YAML::Node value = node_[key];
  if (!value.IsDefined()) return std::nullopt;
  return YamlReader(file_, value);
}

YamlReader YamlReader::at(const std::string& key) const {
  const auto value = find(key);
  if (!value) fail("'" + key + "' is missing");
  return *value;
}

std::vector<YamlReader> YamlReader::items() const {
  if (!node_.IsSequence()) fail("a list is needed");
  std::vector<YamlReader> all;
  for (const YAML::Node& item : node_) all.emplace_back(file_, item);
  return all;
}

void YamlReader::each(const std::function<void(const std::string&, const YamlReader&)>& visit) const {
  if (!node_.IsMap()) fail("a map is needed");
  for (const auto& pair : node_) visit(YamlReader(file_, pair.first).text(), YamlReader(file_, pair.second));
}

std::string YamlReader::text() const {
  if (!node_.IsScalar() || node_.Scalar().empty()) fail("a word is needed");
  return node_.Scalar();
}

double YamlReader::number(double low, double high) const {
  double value = 0.0;
  const bool is_number = node_.IsScalar() && YAML::convert<double>::decode(node_, value) && std::isfinite(value);
  if (!is_number || value < low || value > high) {
    const std::string given = node_.IsScalar() ? "'" + node_.Scalar() + "' is not allowed: " : "";
    fail(given + "a number from " + short_number(low) + " to " + short_number(high) + " is needed");
  }
  return value;
}

std::string YamlReader::choice(const std::vector<std::string>& allowed, const std::string& of_what) const {
  const std::string word = text();
  if (std::find(allowed.begin(), allowed.end(), word) == allowed.end()) {
    fail("no " + of_what + " '" + word + "'" + did_you_mean(word, allowed));
  }
  return word;
}

std::vector<std::string> YamlReader::words() const {
  if (node_.IsScalar()) return {text()};
  std::vector<std::string> all;
  for (const YamlReader& item : items()) all.push_back(item.text());
  return all;
}

double YamlReader::number_or(const std::string& key, double otherwise, double low, double high) const {
  const auto value = find(key);
  return value ? value->number(low, high) : otherwise;
}

std::string YamlReader::text_or(const std::string& key, const std::string& otherwise) const {
  const auto value = find(key);
  return value ? value->text() : otherwise;
}

}  // namespace amiss::scenario::internal
