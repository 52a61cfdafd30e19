#include "page/report_page.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "core/base64.hpp"
#include "core/result.hpp"
#include "page/bundle.hpp"

namespace amiss::page {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kPictureKeys{"colour", "depth", "picture"};

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

/// The last one, and from there back each `step`-th.
std::vector<Json> every(const std::vector<const Json*>& events, std::size_t step) {
  std::vector<Json> kept;
  for (std::size_t i = (events.size() - 1) % step; i < events.size(); i += step) kept.push_back(*events[i]);
  return kept;
}

/// The smallest step that leaves no more than kMostOfAKind, or the last one alone.
std::size_t step_that_fits(const std::vector<std::size_t>& bytes) {
  for (std::size_t step = 2; step < bytes.size(); ++step) {
    std::size_t sum = 0;
    for (std::size_t i = (bytes.size() - 1) % step; i < bytes.size(); i += step) sum += bytes[i];
    if (sum <= kMostOfAKind) return step;
  }
  return bytes.size();
}

std::vector<Json> shortened(const std::string& kind, const std::vector<const Json*>& events) {
  if (kind == "pose") return thinned(events);
  if (kind == "frame") return every(events, (events.size() + kMostFrames - 1) / kMostFrames);
  std::vector<std::size_t> bytes;
  for (const Json* event : events) bytes.push_back(event->dump().size());
  const bool once = kind == "start" || kind == "end" || kind == "examined";
  const std::size_t sum = std::accumulate(bytes.begin(), bytes.end(), std::size_t{0});
  if (kind == "voxels" && sum > kMostOfAKind) return {merged_voxels(events)};
  return every(events, once || sum <= kMostOfAKind ? 1 : step_that_fits(bytes));
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

/// What a page shows of an event, as slices of camera.bin.
std::vector<Slice> slices_of(const Json& event) {
  std::vector<Slice> slices;
  if (event["e"] != "frame" && event["e"] != "examined") return slices;
  for (const char* key : kPictureKeys) {
    if (!event.contains(key)) continue;
    slices.push_back({event[key].at(0).get<std::size_t>(), event[key].at(1).get<std::size_t>()});
  }
  return slices;
}

/// Indices of what has pictures, what is wanted most first: the last frame, examinations, frames from the end on.
std::vector<std::size_t> by_worth(const std::vector<Json>& events) {
  std::vector<std::size_t> frames, order;
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (events[i]["e"] == "frame") frames.push_back(i);
    if (events[i]["e"] == "examined") order.push_back(i);
  }
  if (!frames.empty()) order.insert(order.begin(), frames.back());
  if (!frames.empty()) order.insert(order.end(), frames.rbegin() + 1, frames.rend());
  return order;
}

/// Data addresses by where a picture begins in camera.bin, as many as there is room for. A frame without is forgotten.
Json pictures_of(std::vector<Json>& events, const std::function<std::string(Slice)>& picture) {
  Json pictures = Json::object();
  std::size_t room = kMostPictures;
  std::set<std::size_t> without;
  for (const std::size_t i : by_worth(events)) {
    std::size_t bytes = 0;
    for (const Slice slice : slices_of(events[i])) bytes += slice.bytes;
    if (bytes == 0 || bytes > room) {
      if (events[i]["e"] == "frame") without.insert(i);
      continue;
    }
    room -= bytes;
    for (const Slice slice : slices_of(events[i])) {
      pictures[std::to_string(slice.begin)] = "data:image/jpeg;base64," + base64(picture(slice));
    }
  }
  for (auto i = without.rbegin(); i != without.rend(); ++i)
    events.erase(events.begin() + static_cast<std::ptrdiff_t>(*i));
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
  std::vector<Json> events = shortened(parsed(page.lines));
  Json run;
  run["pictures"] = pictures_of(events, page.picture);
  run["events"] = std::move(events);
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
