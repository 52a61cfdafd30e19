// Camera frames as small JPEG pictures for people.
// RgbdFrame -> half the size (every second pixel) -> colour, or depth as a false-colour picture from near (bright) to
// kFarthest (dark), black where nothing came back; and a frame with the outlines of its segments at full size.
#pragma once

#include <string>
#include <vector>

#include "core/sensors.hpp"
#include "segment/segment.hpp"

namespace amiss::page {

inline constexpr float kFarthestM = 4.0F;

[[nodiscard]] RgbdFrame half_size(const RgbdFrame& frame);
[[nodiscard]] std::string colour_jpeg(const RgbdFrame& frame);
[[nodiscard]] std::string depth_jpeg(const RgbdFrame& frame);
[[nodiscard]] std::string segments_jpeg(const RgbdFrame& frame, const std::vector<segment::Segment>& segments);

/// The colours with the segments' outlines in them.
[[nodiscard]] std::vector<Rgb> outlined(const RgbdFrame& frame, const std::vector<segment::Segment>& segments);

}  // namespace amiss::page
