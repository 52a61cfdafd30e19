// Figures of the objects found over time: a panel for each number of objects and each segmentation time.
#pragma once

#include "experiment/figure.hpp"

namespace amiss::experiment {

[[nodiscard]] Figure found_figure(const Spec& spec, const FigureSpec& figure, const std::vector<TrialResult>& results);

}  // namespace amiss::experiment
