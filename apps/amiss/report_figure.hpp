// Figures of reports that are no experiments: data and gnuplot script -> OUT/figures, the drawing into the page.
#pragma once

#include <filesystem>
#include <string>

#include "experiment/figure.hpp"
#include "report/document.hpp"

namespace amiss::app {

/// The beginning of a script that draws NAME.svg, NAME.pdf or NAME.png, as its variable `format` says, from files of
/// tab-separated values with a heading.
[[nodiscard]] std::string figure_head(const std::string& name);

/// Writes the figure's files and pictures into `folder`/figures. Where gnuplot is missing or cannot draw, the page says
/// so instead of showing it.
void add_figure(report::Document& page, const experiment::Figure& figure, const std::filesystem::path& folder);

}  // namespace amiss::app
