#include "recording/rawlog_recording.hpp"

#include "core/result.hpp"
#include "recording/internal/exact_depth.hpp"
#include "recording/internal/joined.hpp"
#include "recording/rawlog_writer.hpp"

namespace amiss::recording {

RawlogRecording::RawlogRecording(const std::filesystem::path& file) : path_(file), reader_(file) {
  const std::string documents = RawlogWriter::kDocuments;
  bool has_setup = false;
  while ((first_ = reader_.next())) {
    const auto* data = std::get_if<RawlogData>(&*first_);
    if (data == nullptr) break;
    if (data->label == RawlogWriter::kSetup) {
      try {
        setup_ = parse_setup(data->bytes);
      } catch (const InputError& e) {
        throw InputError(file.string() + ": " + e.what());
      }
      has_setup = true;
    } else if (data->label.starts_with(documents)) {
      documents_[data->label.substr(documents.size())] = data->bytes;
    } else {
      break;
    }
  }
  if (has_setup) return;
  const bool is_cut = !first_ && !reader_.complete();
  throw InputError(file.string() + ": does not hold what a replay needs" + (is_cut ? ", or breaks off before it" : "") +
                   " (`amiss tidy --record rawlog` makes one that does)");
}

std::optional<Entry> RawlogRecording::next() {
  while (auto object = first_ ? std::exchange(first_, std::nullopt) : reader_.next()) {
    const auto* data = std::get_if<RawlogData>(&*object);
    try {
      if (data == nullptr) {
        keep(*object);
      } else if (auto entry = entry_of(*data)) {
        return entry;
      }
    } catch (const InputError& e) {
      throw InputError(path_.string() + ": " + (data == nullptr ? "" : data->label + ": ") + e.what());
    }
  }
  return std::nullopt;
}

void RawlogRecording::keep(RawlogObject& object) {
  if (auto* scan = std::get_if<RawlogScan>(&object)) scan_.emplace().ranges_m = std::move(scan->ranges_m);
  if (auto* frame = std::get_if<RawlogFrame>(&object)) rounded_ = std::move(*frame);
}

void RawlogRecording::keep_frame(const RawlogFrame& frame, const std::vector<std::uint32_t>& rest) {
  if (rest.size() != frame.depth.size()) throw InputError("holds another number of pixels than its image");
  if (frame.depth_unit_m != internal::kDepthUnitM) throw InputError("its image is not in millimetres");
  frame_.emplace().intrinsics = frame.camera;
  frame_->depth_m.resize(rest.size());
  for (std::size_t i = 0; i < rest.size(); ++i) {
    frame_->depth_m[i] = internal::exact_depth(frame.depth[i], rest[i]);
  }
}

std::optional<Entry> RawlogRecording::entry_of(const RawlogData& data) {
  if (data.label == RawlogWriter::kObservation) return internal::joined(data.bytes, scan_, frame_);
  if (data.label == RawlogWriter::kSegmented) segmented_ = data.bytes;
  if (data.label == RawlogWriter::kDepth) {
    if (!rounded_) throw InputError("has no image in front of it");
    keep_frame(*rounded_, data.numbers);
    rounded_.reset();
  }
  if (data.label != RawlogWriter::kDecisions) return std::nullopt;
  const Decision decision = parse_decision(data.bytes);
  if (decision.kind == Decision::Kind::kSegmenting) return Segmenting{segmented_};
  return decision;
}

}  // namespace amiss::recording
