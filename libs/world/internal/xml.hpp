// Small helpers around tinyxml2.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <string_view>
#include <vector>

namespace tinyxml2 {
class XMLDocument;
class XMLElement;
}  // namespace tinyxml2

namespace amiss::world {

constexpr std::size_t kMaxSdfBytes = std::size_t{64} << 20;

/// InputError with file:line where `bytes` is not well-formed XML, or nests deeper than any real file.
void parse_xml(tinyxml2::XMLDocument& document, const std::string& bytes, const std::string& file);

[[nodiscard]] bool is_named(const tinyxml2::XMLElement& element, std::string_view name);
/// As a list, so that children may be taken out while going through it.
[[nodiscard]] std::vector<tinyxml2::XMLElement*> children(tinyxml2::XMLElement& element);
/// Trimmed; "" where it is not there.
[[nodiscard]] std::string text_of_child(const tinyxml2::XMLElement& element, const char* child);
[[nodiscard]] std::string text_of_attribute(const tinyxml2::XMLElement& element, const char* attribute);
/// "x y z roll pitch yaw" as SDF has it.
[[nodiscard]] std::string pose_text(const Eigen::Isometry3d& T);

}  // namespace amiss::world
