#include "dataset/annotation_file.hpp"

#include <algorithm>
#include <charconv>

#include "dataset/internal/records.hpp"
#include "dataset/internal/text.hpp"

namespace amiss::dataset {
namespace {

std::uint32_t index_of(std::string_view word, const std::string& name, int line, std::size_t points) {
  std::uint32_t index = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
  if (error != std::errc() || end != word.data() + word.size()) {
    refuse_line(name, line, "'" + shown(word) + "' is no index of a point");
  }
  if (index >= points) {
    refuse_line(name, line, "point " + std::string(word) + " is not there; the cloud has " + std::to_string(points));
  }
  return index;
}

bool is_one_object(std::string_view a, std::string_view b) {
  constexpr std::string_view kInParts = "airplane";
  return a == b || (a.find(kInParts) != a.npos && b.find(kInParts) != b.npos);
}

AnnotatedObject& object_named(std::vector<AnnotatedObject>& objects, std::string_view name) {
  const auto found =
      std::find_if(objects.begin(), objects.end(), [&](const auto& o) { return is_one_object(o.name, name); });
  return found != objects.end() ? *found : objects.emplace_back(AnnotatedObject{std::string(name), {}, {}});
}

}  // namespace

std::vector<AnnotatedObject> parse_annotations(std::string_view bytes, const std::string& name, std::size_t points) {
  std::vector<AnnotatedObject> objects;
  LineReader lines(bytes);
  while (const auto line = lines.next()) {
    auto words = words_of(*line);
    if (words.empty()) continue;
    const bool says = words.back() == "true" || words.back() == "false";
    if (says && words.size() == 1) refuse_line(name, lines.line(), "a line must begin with the object's name");
    AnnotatedObject& object = object_named(objects, words.front());
    if (says) {
      object.on_floor = words.back() == "true";
      words.pop_back();
    }
    for (std::size_t i = 1; i < words.size(); ++i) {
      object.points.push_back(index_of(words[i], name, lines.line(), points));
    }
  }
  return objects;
}

std::string annotation_bytes(const std::vector<AnnotatedObject>& objects) {
  std::string text;
  for (const AnnotatedObject& object : objects) {
    text += object.name;
    for (const std::uint32_t index : object.points) text += " " + std::to_string(index);
    if (object.on_floor) text += *object.on_floor ? " true" : " false";
    text += "\n";
  }
  return text;
}

}  // namespace amiss::dataset
