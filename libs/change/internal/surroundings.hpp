// What the reference has around a part that is not where it was, and that makes it no object: a surface of which the
// part is only more, seen for the first time, or an edge that stood a few centimetres beside it.
// in: two rooms laid on one another, points of the current one. out: whether it is so of a point, and of which share of
// points, 0 .. 1.
#pragma once

#include "change/internal/room_pair.hpp"

namespace amiss::change::internal {

/// Point i of the current room goes on in the plane of a surface of the reference and in its colour, where the
/// reference did not see empty space. Without a map of space all is taken as seen, and nothing continues.
[[nodiscard]] bool continues(const RoomPair& pair, std::uint32_t i, const NovelParams& params);

/// Point i has something of its colour in the reference beside it, at its own height and at most nudge_m away:
/// furniture is nudged level, and leaves a strip along its edges. What lies flat on a surface is higher than the
/// surface.
[[nodiscard]] bool nudged(const RoomPair& pair, std::uint32_t i, const NovelParams& params);

/// Shares of the points of which that holds.
[[nodiscard]] double continued_share(const RoomPair& pair, const segment::Indices& points, const NovelParams& params);
[[nodiscard]] double nudged_share(const RoomPair& pair, const segment::Indices& points, const NovelParams& params);

}  // namespace amiss::change::internal
