// report.html of an experiment: tables, figures, spec, parameters and versions in one file that opens without a server
// and without a network. The same results give the same bytes.
#pragma once

#include <string>
#include <vector>

#include "experiment/folder.hpp"

namespace amiss::experiment {

/// A figure as SVG, as gnuplot writes it.
struct DrawnFigure {
  std::string name, title, svg;
};
[[nodiscard]] std::string to_html(const Folder& folder, const std::vector<DrawnFigure>& figures);

/// The svg element alone, every id in it beginning with `prefix`, so that several stand in one page.
[[nodiscard]] std::string inlined(std::string_view svg, const std::string& prefix);

}  // namespace amiss::experiment
