// What a fit of a candidate rests on: the stuff of the reference it would have come from, and whether that can be.
#pragma once

#include "change/internal/object_fit.hpp"
#include "change/internal/room_pair.hpp"

namespace amiss::change::internal {

struct Counterpart {
  double taken = 0.0;            // share of the matched stuff that something else still explains where it was
  double left_over = 0.0;        // share of the stuff that has gone which the same motion would carry into empty space
  double colour_distance = 0.0;  // median over the matched pairs; 0 without colours
};

[[nodiscard]] Counterpart counterpart_of(const RoomPair& pair, const segment::Indices& candidate, const Fit& fit,
                                         const NovelParams& params);

}  // namespace amiss::change::internal
