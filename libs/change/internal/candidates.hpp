// Candidates (Section 5.2.1): clusters of what stands on surfaces, and clusters of what is labelled otherprop.
#pragma once

#include "change/internal/verification.hpp"

namespace amiss::change::internal {

enum class From { kPlanesAndLabels, kLabels };

/// Largest first; each point is in one candidate at most.
[[nodiscard]] std::vector<Candidate> candidates_of(const ThinnedScene& current, const std::vector<Support>& supports,
                                                   From from, const NovelParams& params);

}  // namespace amiss::change::internal
