#include "recording/recording.hpp"

#include "core/result.hpp"
#include "recording/internal/joined.hpp"

namespace amiss::recording {

Recording::Recording(const std::filesystem::path& file) : path_(file), reader_(file) {
  while (const auto message = reader_.next()) {
    if (message->channel->schema != "amiss_msgs/msg/Setup") continue;
    try {
      setup_ = parse_setup(message->data);
    } catch (const InputError& e) {
      throw InputError(file.string() + ": " + e.what());
    }
    return;
  }
  throw InputError(file.string() + ": is no recording of a run" +
                   (reader_.complete() ? "" : ", or breaks off before it begins") +
                   " (`amiss tidy --record mcap` makes one)");
}

std::optional<Entry> Recording::next() {
  while (const auto message = reader_.next()) {
    const std::string& topic = message->channel->topic;
    try {
      if (topic == "/scan") parse_ranges(message->data, scan_.emplace());
      if (topic == "/camera/camera_info") parse_camera_info(message->data, camera_);
      if (topic == "/camera/depth/image_raw") {
        frame_.emplace().intrinsics = camera_;
        parse_depth(message->data, *frame_);
      }
      if (topic == "/amiss/segmented") segmented_ = message->data;
      if (topic == "/amiss/observation") return internal::joined(message->data, scan_, frame_);
      if (topic == "/amiss/decisions") {
        const Decision decision = parse_decision(message->data);
        if (decision.kind == Decision::Kind::kSegmenting) return Segmenting{segmented_};
        return decision;
      }
    } catch (const InputError& e) {
      throw InputError(path_.string() + ": " + topic + " at " + std::to_string(seconds(message->stamp)) +
                       " s: " + e.what());
    }
  }
  return std::nullopt;
}

}  // namespace amiss::recording
