#include "experiment/figure.hpp"

#include <algorithm>

#include "experiment/internal/box_figure.hpp"
#include "experiment/internal/found_figure.hpp"

namespace amiss::experiment {

std::optional<Figure> figure_of(const Spec& spec, const FigureSpec& figure, const std::vector<TrialResult>& results) {
  std::vector<TrialResult> here;
  std::copy_if(results.begin(), results.end(), std::back_inserter(here),
               [&](const TrialResult& r) { return r.trial.world == figure.world; });
  if (here.empty()) return std::nullopt;
  return figure.shows == FigureSpec::Shows::kFound ? found_figure(spec, figure, here) : box_figure(spec, figure, here);
}

}  // namespace amiss::experiment
