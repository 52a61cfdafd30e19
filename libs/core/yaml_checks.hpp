// Reading YAML with distrust: what every reader of a list or map in a file checks, with one way to say what is wrong.
// In: a file or a node of it (yaml-cpp). Out: values. Errors: InputError "file:line: what is wrong; what is allowed".
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace YAML {
class Node;
}

namespace amiss {

/// The root of a file no larger than 1 MiB.
[[nodiscard]] YAML::Node load_yaml(const std::filesystem::path& file);
/// "file:line: " of a node.
[[nodiscard]] std::string yaml_place(const std::filesystem::path& file, const YAML::Node& node);
/// The item is a map whose keys are all known and which has those that are needed; `example` says what is allowed.
void check_yaml_keys(const std::filesystem::path& file, const YAML::Node& item, const std::vector<std::string>& known,
                     const std::vector<std::string>& needed, std::string_view example);
/// A number from -1000 to 1000, or the fallback where the key is not there.
[[nodiscard]] double yaml_number(const std::filesystem::path& file, const YAML::Node& item, const std::string& key,
                                 double fallback);
/// A text that is there and not empty.
[[nodiscard]] std::string yaml_text(const std::filesystem::path& file, const YAML::Node& item, const std::string& key);

/// The shortest text that reads back as the same number, and a text in single quotes.
[[nodiscard]] std::string yaml_exact(double value);
[[nodiscard]] std::string yaml_quoted(std::string_view text);

}  // namespace amiss
