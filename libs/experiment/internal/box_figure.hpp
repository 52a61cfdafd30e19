// Figures of boxes: segmentation actions or times for each number of objects.
#pragma once

#include "experiment/figure.hpp"

namespace amiss::experiment {

[[nodiscard]] Figure box_figure(const Spec& spec, const FigureSpec& figure, const std::vector<TrialResult>& results);

}  // namespace amiss::experiment
