// Candidates (Section 5.2.1): clusters of what stands on surfaces, and clusters of what is labelled otherprop.
#pragma once

#include "change/internal/verification.hpp"

namespace amiss::change::internal {

enum class From { kPlanesAndLabels, kLabels };
/// Points of surfaces that are labelled otherprop: a table top beside a labelled cup, or the top of a box.
enum class Surfaces { kLeftOut, kKept };

/// Each point is in one candidate at most; largest first, with kKept on each surface.
[[nodiscard]] std::vector<Candidate> candidates_of(const ThinnedScene& current, const std::vector<Support>& supports,
                                                   From from, Surfaces surfaces, const NovelParams& params);

}  // namespace amiss::change::internal
