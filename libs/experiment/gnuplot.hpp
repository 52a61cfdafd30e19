// Figures drawn by gnuplot, in a process of its own: figure -> its pictures.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "experiment/figure.hpp"

namespace amiss::experiment {

/// NAME.svg, NAME.pdf and NAME.png -> bytes, the same whenever and wherever they are drawn by the same gnuplot.
/// `scratch`: a folder for the time of drawing, empty or not there yet; gone afterwards. InputError when gnuplot is not
/// installed, std::runtime_error with its own words when it draws nothing. `program`: gnuplot's name.
[[nodiscard]] std::map<std::string, std::string> drawn(const Figure& figure, const std::filesystem::path& scratch,
                                                       const std::string& program = "gnuplot");

}  // namespace amiss::experiment
