// When two bounding cylinders are of one region, and what both together are.
#pragma once

#include "knowledge/knowledge_base.hpp"

namespace amiss::knowledge::internal {

/// Area that two circles share, as a part of the smaller one's.
[[nodiscard]] double shared_part(const Cylinder& a, const Cylinder& b);

[[nodiscard]] bool same_region(const Cylinder& a, const Cylinder& b, const Params& params);

/// The smallest upright cylinder round both.
[[nodiscard]] Cylinder enclosing(const Cylinder& a, const Cylinder& b);

/// Sightings of one region joined, until no two are of one region; ordered by position.
[[nodiscard]] std::vector<Sighting> joined(std::vector<Sighting> sightings, const Params& params);

/// Is `now` so much larger than `then` that it is worth another look?
[[nodiscard]] bool grown_noticeably(const Cylinder& then, const Cylinder& now, const Params& params);

}  // namespace amiss::knowledge::internal
