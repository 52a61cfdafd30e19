#include "page/report_page.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base64.hpp"
#include "core/result.hpp"
#include "page/bundle.hpp"

namespace amiss::page {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 2> kPictureKeys{"colour", "picture"};

std::vector<Json> parsed(const std::vector<std::string>& lines) {
  std::vector<Json> events;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Json json = Json::parse(lines[i], nullptr, false);
    if (!json.is_object() || !json.contains("e") || !json["e"].is_string() || !json.contains("t")) {
      throw InputError("timeline, line " + std::to_string(i + 1) + ": an event of a run is allowed");
    }
    events.push_back(std::move(json));
  }
  return events;
}

/// Three 16-bit indices, still in base64: eight characters, for six bytes are two groups of four digits.
constexpr std::size_t kVoxelText = 8;

/// Voxels that are occupied after all events, as one event from the beginning on.
Json merged_voxels(const std::vector<const Json*>& events) {
  std::set<std::string> occupied;
  for (const Json* event : events) {
    const auto& on = (*event)["on"].get_ref<const std::string&>();
    const auto& off = (*event)["off"].get_ref<const std::string&>();
    for (std::size_t i = 0; i < on.size(); i += kVoxelText) occupied.insert(on.substr(i, kVoxelText));
    for (std::size_t i = 0; i < off.size(); i += kVoxelText) occupied.erase(off.substr(i, kVoxelText));
  }
  std::string text;
  for (const std::string& voxel : occupied) text += voxel;
  return {{"e", "voxels"}, {"t", 0.0}, {"on", text}, {"off", ""}};
}

std::vector<Json> thinned(const std::vector<const Json*>& poses) {
  const std::size_t step = (poses.size() + kMostPoses - 1) / kMostPoses;
  std::vector<Json> kept;
  for (std::size_t i = 0; i < poses.size(); i += step) kept.push_back(*poses[i]);
  if (!poses.empty() && (poses.size() - 1) % step != 0) kept.push_back(*poses.back());
  return kept;
}

std::vector<Json> shortened(const std::string& kind, const std::vector<const Json*>& events) {
  if (kind == "pose") return thinned(events);
  if (kind == "frame") return {*events.back()};
  std::size_t bytes = 0;
  for (const Json* event : events) bytes += event->dump().size();
  const bool once = kind == "start" || kind == "end" || kind == "examined";
  if (once || bytes <= kMostOfAKind) {
    std::vector<Json> all;
    for (const Json* event : events) all.push_back(*event);
    return all;
  }
  if (kind == "voxels") return {merged_voxels(events)};
  return {*events.back()};
}

std::vector<Json> shortened(const std::vector<Json>& events) {
  std::map<std::string, std::vector<const Json*>> kinds;
  for (const Json& event : events) kinds[event["e"].get<std::string>()].push_back(&event);
  std::vector<Json> kept;
  for (const auto& [kind, list] : kinds) {
    for (Json& event : shortened(kind, list)) kept.push_back(std::move(event));
  }
  const auto place = [](const Json& event) {
    const int at_the_end = event["e"] == "start" ? -1 : (event["e"] == "end" ? 1 : 0);
    return std::pair(at_the_end, event["t"].get<double>());
  };
  std::stable_sort(kept.begin(), kept.end(), [&](const Json& a, const Json& b) { return place(a) < place(b); });
  return kept;
}

/// Data addresses by where a picture begins in camera.bin.
Json pictures_of(const std::vector<Json>& events, const std::function<std::string(Slice)>& picture) {
  Json pictures = Json::object();
  std::size_t room = kMostPictures;
  const auto add = [&](const Json& slice) {
    const Slice wanted{slice.at(0).get<std::size_t>(), slice.at(1).get<std::size_t>()};
    if (wanted.bytes == 0 || wanted.bytes > room) return;
    room -= wanted.bytes;
    pictures[std::to_string(wanted.begin)] = "data:image/jpeg;base64," + base64(picture(wanted));
  };
  for (const Json& event : events) {
    if (event["e"] == "frame") add(event["depth"]);
    for (const std::string_view key : kPictureKeys) {
      const bool has = (event["e"] == "frame" || event["e"] == "examined") && event.contains(key);
      if (has) add(event[std::string(key)]);
    }
  }
  return pictures;
}

/// JSON that can stand in a script element: no tag can begin in it.
std::string in_script(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace), safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

void replace(std::string& text, std::string_view what, std::string_view with) {
  const std::size_t at = text.find(what);
  if (at != std::string::npos) text.replace(at, what.size(), with);
}

constexpr std::string_view kContentPolicy =
    R"(<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; )"
    R"(style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none'">)";

}  // namespace

std::string to_html(const ReportPage& page) {
  const std::vector<Json> events = shortened(parsed(page.lines));
  Json run;
  run["events"] = events;
  run["pictures"] = pictures_of(events, page.picture);
  run["texts"] = page.texts;
  run["texts"]["licences.txt"] = bundled("/licences.txt");

  std::string html(bundled("/"));
  replace(html, R"(<link rel="stylesheet" href="/app.css">)",
          std::string(kContentPolicy) + "\n<style>" + std::string(bundled("/app.css")) + "</style>");
  replace(html, R"(<script src="/app.js" defer></script>)", "");
  replace(html, "</body>",
          "<script type=\"application/json\" id=\"run\">" + in_script(run) + "</script>\n<script>" +
              std::string(bundled("/app.js")) + "</script>\n</body>");
  return html;
}

}  // namespace amiss::page
