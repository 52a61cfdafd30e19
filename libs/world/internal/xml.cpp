#include "world/internal/xml.hpp"

#include <tinyxml2.h>

#include <cmath>
#include <cstdio>

#include "core/result.hpp"

namespace amiss::world {
namespace {

constexpr int kMaxDepth = 100;

std::string trimmed(const char* text) {
  if (text == nullptr) return {};
  const std::string_view all(text);
  const std::size_t first = all.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return std::string(all.substr(first, all.find_last_not_of(" \t\r\n") - first + 1));
}

/// Depth of nesting from the tags alone, before any recursive reader sees the text.
bool nests_too_deep(const std::string& bytes) {
  int depth = 0;
  for (std::size_t i = 0; (i = bytes.find('<', i)) != std::string::npos; ++i) {
    const char next = i + 1 < bytes.size() ? bytes[i + 1] : '\0';
    if (next == '!') {
      const bool comment = bytes.compare(i, 4, "<!--") == 0;
      i = bytes.find(comment ? "-->" : ">", i + (comment ? 4 : 1));
      if (i == std::string::npos) return false;
      continue;
    }
    if (next == '?') continue;
    const std::size_t end = bytes.find('>', i);
    if (end == std::string::npos) return false;
    if (next == '/') {
      --depth;
    } else if (bytes[end - 1] != '/' && ++depth > kMaxDepth) {
      return true;
    }
  }
  return false;
}

}  // namespace

void parse_xml(tinyxml2::XMLDocument& document, const std::string& bytes, const std::string& file) {
  if (bytes.find_first_not_of(" \t\r\n") == std::string::npos) throw InputError(file + ": the file is empty");
  if (bytes.find('\0') != std::string::npos) {
    throw InputError(file + ": not an XML file, it holds zero bytes");
  }
  if (nests_too_deep(bytes)) {
    throw InputError(file + ": elements nest deeper than " + std::to_string(kMaxDepth) + " levels");
  }
  const tinyxml2::XMLError error = document.Parse(bytes.data(), bytes.size());
  if (error != tinyxml2::XML_SUCCESS) {
    std::string kind = document.ErrorIDToName(error);
    if (kind.rfind("XML_ERROR_", 0) == 0) kind = kind.substr(10);
    throw InputError(file + ":" + std::to_string(document.ErrorLineNum()) + ": not well-formed XML (" + kind +
                     "); is the file cut short?");
  }
}

bool is_named(const tinyxml2::XMLElement& element, std::string_view name) { return name == element.Name(); }

std::vector<tinyxml2::XMLElement*> children(tinyxml2::XMLElement& element) {
  std::vector<tinyxml2::XMLElement*> list;
  for (tinyxml2::XMLElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    list.push_back(child);
  }
  return list;
}

std::string text_of_child(const tinyxml2::XMLElement& element, const char* child) {
  const tinyxml2::XMLElement* found = element.FirstChildElement(child);
  return found != nullptr ? trimmed(found->GetText()) : std::string();
}

std::string text_of_attribute(const tinyxml2::XMLElement& element, const char* attribute) {
  return trimmed(element.Attribute(attribute));
}

std::string pose_text(const Eigen::Isometry3d& T) {
  const Eigen::Matrix3d R = T.linear();
  const double pitch = std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)));
  const double roll = std::atan2(R(2, 1), R(2, 2)), yaw = std::atan2(R(1, 0), R(0, 0));
  char text[200];
  std::snprintf(text, sizeof text, "%.12g %.12g %.12g %.12g %.12g %.12g", T.translation().x(), T.translation().y(),
                T.translation().z(), roll, pitch, yaw);
  return text;
}

}  // namespace amiss::world
