#include "page/internal/shorter_run.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>

#include "core/base64.hpp"
#include "page/report_page.hpp"

namespace amiss::page {

namespace {

using Json = nlohmann::ordered_json;

/// Three 16-bit indices, still in base64: eight characters, for six bytes are two groups of four digits.
constexpr std::size_t kVoxelText = 8;

/// How much of a map fits, in parts of what a kind of event is given.
constexpr std::size_t kPartsForReference = 8, kPartsForMap = 4;

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
  return {{"e", "voxels"}, {"t", 0.0}, {"merged", true}, {"on", text}, {"off", ""}};
}

/// The voxels of the lower layers, as many whole layers as fit.
std::string lower_layers(const std::string& voxels, std::size_t most_text) {
  constexpr std::size_t kBytes = 6, kHeight = 4;  // of a voxel; where its last index begins
  const std::string bytes = from_base64(voxels);
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(bytes[i])); };
  std::map<std::int16_t, std::string> layers;
  for (std::size_t i = 0; i + kBytes <= bytes.size(); i += kBytes) {
    const unsigned height = byte(i + kHeight) | (byte(i + kHeight + 1) << 8U);
    layers[static_cast<std::int16_t>(height)].append(bytes, i, kBytes);
  }
  std::string kept;
  for (const auto& [height, layer] : layers) {
    if ((kept.size() + layer.size()) / kBytes * kVoxelText > most_text) break;
    kept += layer;
  }
  return base64(kept);
}

/// True where voxels had to go.
bool cut(Json& event, const char* key, std::size_t most_text) {
  if (!event.contains(key) || event[key].get_ref<const std::string&>().size() <= most_text) return false;
  event[key] = lower_layers(event[key].get<std::string>(), most_text);
  return true;
}

/// The last one, and from there back each `step`-th.
std::vector<Json> every(const std::vector<const Json*>& events, std::size_t step) {
  std::vector<Json> kept;
  for (std::size_t i = (events.size() - 1) % step; i < events.size(); i += step) kept.push_back(*events[i]);
  return kept;
}

/// The same with the first one too: a path has two ends.
std::vector<Json> thinned(const std::vector<const Json*>& poses, std::size_t most) {
  const std::size_t step = (poses.size() + most - 1) / most;
  std::vector<Json> kept = every(poses, step);
  if ((poses.size() - 1) % step != 0) kept.insert(kept.begin(), *poses.front());
  return kept;
}

/// The smallest step that leaves no more than `most` bytes, or the last one alone.
std::size_t step_that_fits(const std::vector<std::size_t>& bytes, std::size_t most) {
  for (std::size_t step = 1; step < bytes.size(); ++step) {
    std::size_t sum = 0;
    for (std::size_t i = (bytes.size() - 1) % step; i < bytes.size(); i += step) sum += bytes[i];
    if (sum <= most) return step;
  }
  return bytes.size();
}

std::vector<Json> shortened(const std::string& kind, const std::vector<const Json*>& events, std::size_t most) {
  if (kind == "start" || kind == "end") return every(events, 1);
  if (kind == "frame") return every(events, (events.size() + kMostFrames - 1) / kMostFrames);
  if (kind == "pose") return thinned(events, std::max<std::size_t>(2, kMostPoses * most / kMostOfAKind));
  std::vector<std::size_t> bytes;
  for (const Json* event : events) bytes.push_back(event->dump().size());
  if (kind == "voxels" && std::accumulate(bytes.begin(), bytes.end(), std::size_t{0}) > most) {
    return {merged_voxels(events)};
  }
  return every(events, step_that_fits(bytes, most));
}

/// What a single event may take. True where voxels of a map had to go.
bool limit(Json& event, std::size_t most) {
  if (event["e"] == "end" && event.dump().size() > most) event["report"].erase("collision_list");  // events tell them
  if (event["e"] == "difference") {
    const bool appeared = cut(event, "appeared", most / 2), vanished = cut(event, "vanished", most / 2);
    return appeared || vanished;
  }
  if (event["e"] == "voxels") return cut(event, "on", kPartsForMap * most);
  return event["e"] == "start" && cut(event, "reference", kPartsForReference * most);
}

}  // namespace

std::vector<Json> shortened(const std::vector<Json>& events, std::size_t most_of_a_kind) {
  std::map<std::string, std::vector<const Json*>> kinds;
  for (const Json& event : events) kinds[event["e"].get<std::string>()].push_back(&event);
  std::vector<Json> kept;
  bool lower = false;
  for (const auto& [kind, list] : kinds) {
    for (Json& event : shortened(kind, list, most_of_a_kind)) {
      lower = limit(event, most_of_a_kind) || lower;
      kept.push_back(std::move(event));
    }
  }
  if (lower) {
    kept.push_back(
        {{"e", "log"}, {"t", 0.0}, {"text", "maps without their upper layers: they do not fit into a report"}});
  }
  const auto place = [](const Json& event) {
    const int at_the_end = event["e"] == "start" ? -1 : (event["e"] == "end" ? 1 : 0);
    return std::pair(at_the_end, event["t"].get<double>());
  };
  std::stable_sort(kept.begin(), kept.end(), [&](const Json& a, const Json& b) { return place(a) < place(b); });
  return kept;
}

}  // namespace amiss::page
