// Flat things: where the reference has the same surface, but in no colour that is like this one. What is lower than d
// of Equation 5.1 is explained by the geometry of what it lies on; its colour is not. in: two rooms laid on one
// another. out: points of the current room, ascending; none where either has no colours.
#pragma once

#include "change/internal/room_pair.hpp"

namespace amiss::change::internal {

/// Points that face up, that the reference has at their place, and near which (detect.recolour_reach: things are
/// nudged) the reference has nothing at their height whose colour is nearer than detect.recolour, in whatever
/// light.
[[nodiscard]] segment::Indices recoloured(const RoomPair& pair, const NovelParams& params);

}  // namespace amiss::change::internal
