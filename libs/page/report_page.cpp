#include "page/report_page.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base64.hpp"
#include "core/result.hpp"
#include "page/bundle.hpp"
#include "page/internal/shorter_run.hpp"

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

/// The last one first, and then so that any beginning of the order is spread over all.
std::vector<std::size_t> spread(const std::vector<std::size_t>& list) {
  std::vector<std::size_t> order;
  std::set<std::size_t> taken;
  for (std::size_t step = std::bit_ceil(list.size()); step > 0; step /= 2) {
    for (std::size_t back = 0; back < list.size(); back += step) {
      if (taken.insert(back).second) order.push_back(list[list.size() - 1 - back]);
    }
  }
  return order;
}

/// Indices of what has pictures, what is wanted most first: the last frame, examinations, frames over the run.
std::vector<std::size_t> by_worth(const std::vector<Json>& events) {
  std::vector<std::size_t> frames, order;
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (events[i]["e"] == "frame") frames.push_back(i);
    if (events[i]["e"] == "examined") order.push_back(i);
  }
  const std::vector<std::size_t> over_the_run = spread(frames);
  if (!frames.empty()) order.insert(order.begin(), over_the_run.front());
  if (!frames.empty()) order.insert(order.end(), over_the_run.begin() + 1, over_the_run.end());
  return order;
}

constexpr std::string_view kDataAddress = "data:image/jpeg;base64,";

/// Bytes that a picture takes in the page, its key and marks included.
std::size_t bytes_in_page(Slice slice) {
  constexpr std::size_t kKeyAndMarks = 20;
  return kDataAddress.size() + (slice.bytes + 2) / 3 * 4 + kKeyAndMarks;
}

/// Data addresses by where a picture begins in camera.bin, as many as there is room for. A frame without is forgotten.
Json pictures_of(std::vector<Json>& events, std::size_t room, const std::function<std::string(Slice)>& picture) {
  Json pictures = Json::object();
  std::set<std::size_t> without;
  for (const std::size_t i : by_worth(events)) {
    std::size_t bytes = 0;
    for (const Slice slice : slices_of(events[i])) bytes += bytes_in_page(slice);
    if (bytes == 0 || bytes > room) {
      if (events[i]["e"] == "frame") without.insert(i);
      continue;
    }
    room -= bytes;
    for (const Slice slice : slices_of(events[i])) {
      pictures[std::to_string(slice.begin)] = std::string(kDataAddress) + base64(picture(slice));
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

/// The page of events, texts by name and pictures.
std::string page_with(const std::vector<Json>& events, const Json& texts, const Json& pictures) {
  const Json run = {{"pictures", pictures}, {"events", events}, {"texts", texts}};
  std::string html(bundled("/"));
  replace(html, R"(<link rel="stylesheet" href="/app.css">)",
          std::string(kContentPolicy) + "\n<style>" + std::string(bundled("/app.css")) + "</style>");
  replace(html, R"(<script src="/app.js" defer></script>)", "");
  replace(html, "</body>",
          "<script type=\"application/json\" id=\"run\">" + in_script(run) + "</script>\n<script>" +
              std::string(bundled("/app.js")) + "</script>\n</body>");
  return html;
}

/// Beside the program's version, where the page shows it.
void add_libraries(std::vector<Json>& events, const std::string& libraries) {
  for (Json& event : events) {
    if (event["e"] == "start" && event.contains("version") && !libraries.empty()) {
      event["version"] = event["version"].get<std::string>() + "; " + libraries;
    }
  }
}

}  // namespace

std::string to_html(const ReportPage& page) {
  constexpr std::size_t kLeastOfAKind = kMostOfAKind / 64;  // a run that is larger even so is not of this world
  std::vector<Json> whole = parsed(page.lines);
  add_libraries(whole, page.libraries);
  Json texts = page.texts;
  texts["licences.txt"] = bundled("/licences.txt");

  std::vector<Json> events;
  std::size_t taken = kMostBytes;
  for (std::size_t most = kMostOfAKind; most >= kLeastOfAKind && taken + kLeastForPictures > kMostBytes; most /= 2) {
    events = shortened(whole, most);
    taken = page_with(events, texts, Json::object()).size();
  }
  const std::size_t room = kMostBytes - std::min(kMostBytes, taken);
  const Json pictures = pictures_of(events, room, page.picture);
  return page_with(events, texts, pictures);
}

}  // namespace amiss::page
