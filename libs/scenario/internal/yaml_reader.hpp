// A YAML node with the file it comes from: what is read is checked, and what is wrong is said with line and column.
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace amiss::scenario::internal {

class YamlReader {
 public:
  YamlReader(std::string file, YAML::Node node) : file_(std::move(file)), node_(std::move(node)) {}

  /// "file:line:column"
  [[nodiscard]] std::string where() const;
  [[noreturn]] void fail(const std::string& what) const;  // InputError
  [[nodiscard]] bool is_map() const { return node_.IsMap(); }
  [[nodiscard]] bool is_list() const { return node_.IsSequence(); }

  /// The node must be a map with no other keys than these; a wrong one is named with the nearest and all allowed.
  void allow(const std::vector<std::string>& keys) const;
  [[nodiscard]] std::optional<YamlReader> find(const std::string& key) const;
  [[nodiscard]] YamlReader at(const std::string& key) const;  // an error where it is missing
  [[nodiscard]] std::vector<YamlReader> items() const;        // of a list
  void each(const std::function<void(const std::string& key, const YamlReader& value)>& visit) const;  // of a map

  [[nodiscard]] std::string text() const;
  [[nodiscard]] double number(double low, double high) const;
  [[nodiscard]] std::string choice(const std::vector<std::string>& allowed, const std::string& of_what) const;
  /// A list of words, or one word.
  [[nodiscard]] std::vector<std::string> words() const;

  [[nodiscard]] double number_or(const std::string& key, double otherwise, double low, double high) const;
  [[nodiscard]] std::string text_or(const std::string& key, const std::string& otherwise) const;

 private:
  std::string file_;
  YAML::Node node_;
};

}  // namespace amiss::scenario::internal
