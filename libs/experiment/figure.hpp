// A figure of an experiment: spec and results -> data (tab-separated) and the gnuplot script that draws them. Boxes are
// quartiles with whiskers to the last value within 1.5 times their distance, every trial is a point; trials that did
// not find all are counted above their box. Objects found over time are drawn as median and quartiles of the trials.
// Thesis, Figures 4.6 to 4.9.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "experiment/result.hpp"

namespace amiss::experiment {

struct Figure {
  std::string name, title;
  std::map<std::string, std::string> files;  // name of the file -> bytes; the script is NAME.gp
};

/// Nothing while none of its trials has a result.
[[nodiscard]] std::optional<Figure> figure_of(const Spec& spec, const FigureSpec& figure,
                                              const std::vector<TrialResult>& results);

/// The formats that a script draws: the value of its variable `format`, and the extension of what it writes.
inline constexpr const char* kFigureFormats[] = {"svg", "pdf", "png"};

}  // namespace amiss::experiment
