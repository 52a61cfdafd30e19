#include "experiment/internal/gnuplot_script.hpp"

#include <fmt/format.h>

#include "report/search_times.hpp"

namespace amiss::experiment {

std::string in_quotes(std::string_view text) {
  std::string words = "'";
  for (const char c : text) {
    if (c == '\'') words += c;
    words += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return words + "'";
}

std::string script_head(const std::string& name) {
  return fmt::format(
      "# gnuplot -e \"format='svg'\" {0}.gp   (svg, pdf or png)\n"
      "if (!exists('format')) format = 'svg'\n"
      "if (format eq 'svg') set terminal svg size 840,520 name '{0}' noenhanced font 'DejaVu Sans,13' "
      "background '#ffffff'\n"
      "if (format eq 'pdf') set terminal pdfcairo size 16cm,10cm noenhanced font 'DejaVu Sans,9'\n"
      "if (format eq 'png') set terminal pngcairo size 1260,780 noenhanced font 'DejaVu Sans,13' "
      "background '#ffffff'\n"
      "set output '{0}.' . format\n"
      "set encoding utf8\n"
      "set datafile separator tab\n"
      "set datafile columnheaders\n"
      "set border 3\n"
      "set tics nomirror\n"
      "set grid ytics lc rgb '#dddddd'\n",
      name);
}

Paint paint_of(std::string_view method, bool again) {
  if (method == report::kDynamic) return again ? Paint{"#56b4e9", "6"} : Paint{"#0072b2", "7"};
  return again ? Paint{"#e69f00", "8"} : Paint{"#d55e00", "9"};
}

}  // namespace amiss::experiment
