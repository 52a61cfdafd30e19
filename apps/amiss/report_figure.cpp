#include "report_figure.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "core/files.hpp"
#include "experiment/gnuplot.hpp"
#include "experiment/page.hpp"

namespace amiss::app {

std::string figure_head(const std::string& name) {
  return fmt::format(
      "# gnuplot -e \"format='svg'\" {0}.gp   (svg, pdf or png)\n"
      "if (!exists('format')) format = 'svg'\n"
      "if (format eq 'svg') set terminal svg size 840,520 name '{0}' noenhanced font 'DejaVu Sans,13'\n"
      "if (format eq 'pdf') set terminal pdfcairo size 16cm,10cm noenhanced font 'DejaVu Sans,9'\n"
      "if (format eq 'png') set terminal pngcairo size 1260,780 noenhanced font 'DejaVu Sans,13'\n"
      "set output '{0}.' . format\n"
      "set encoding utf8\n"
      "set datafile separator tab\n"
      "set datafile columnheaders\n"
      "set border 3\n"
      "set tics nomirror\n"
      "set grid ytics lc rgb '#dddddd'\n"
      "set style fill solid 0.6 noborder\n",
      name);
}

void add_figure(report::Document& page, const experiment::Figure& figure, const std::filesystem::path& folder) {
  const std::filesystem::path figures = folder / "figures";
  std::filesystem::create_directories(figures);
  for (const auto& [name, bytes] : figure.files) save_atomically(figures / name, bytes);
  const std::string data = fmt::format("{}.tsv, {}.gp", figure.name, figure.name);
  try {
    const auto pictures = experiment::drawn(figure, figures / fmt::format(".drawing.{}", ::getpid()));
    for (const auto& [name, bytes] : pictures) save_atomically(figures / name, bytes);
    page.drawing(experiment::inlined(pictures.at(figure.name + ".svg"), figure.name), figure.name,
                 fmt::format("{} (figures/{})", figure.title, data));
  } catch (const std::exception& e) {
    page.paragraph(fmt::format("{} (figures/{}): not drawn. {}.", figure.title, data, e.what()));
  }
}

}  // namespace amiss::app
