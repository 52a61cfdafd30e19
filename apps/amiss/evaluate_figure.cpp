#include "evaluate_figure.hpp"

#include <algorithm>

#include "report_figure.hpp"
#include "score/novel_score.hpp"

namespace amiss::app {

namespace {

/// The rows of the averages, each with a name of its own to stand under its bars.
experiment::Table averages_of(const experiment::Table& table) {
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(table.heading.begin(), table.heading.end(), name) -
                                    table.heading.begin());
  };
  const std::size_t method = column("method"), reconstruction = column("reconstruction");
  experiment::Table averages{{"bars", "precision", "precision_sd", "recall", "recall_sd", "f1", "f1_sd"}, {}};
  for (const auto& row : table.rows) {
    if (row[column("room")] != kAverageRoom) continue;
    std::vector<std::string> cells{reconstruction < row.size() ? row[reconstruction] + ", " + row[method]
                                                               : row[method]};
    for (std::size_t i = 1; i < averages.heading.size(); ++i) cells.push_back(row[column(averages.heading[i])]);
    averages.rows.push_back(std::move(cells));
  }
  return averages;
}

}  // namespace

experiment::Figure averages_figure(const experiment::Table& table, const std::string& name) {
  const std::string file = "'" + name + ".tsv'";
  const std::string script =
      figure_head(name) +
      "set style data histograms\n"
      "set style fill solid 0.6 border lc rgb '#444444'\n"  // the deviations' colour too
      "set style histogram errorbars gap 1.5 lw 1\n"
      "set boxwidth 0.9\n"
      "set yrange [0:1.05]\n"
      "set xtics rotate by 20 right\n"
      "set key above\n"
      "plot " +
      file + " using 'precision':'precision_sd':xtic(strcol('bars')) lc rgb '#0072b2' title 'precision', \\\n     " +
      file + " using 'recall':'recall_sd' lc rgb '#e69f00' title 'recall', \\\n     " + file +
      " using 'f1':'f1_sd' lc rgb '#009e73' title 'F1'\n";
  return {name,
          "Precision, recall and F1 over the points: means of the rooms, standard deviations over all visits",
          {{name + ".tsv", experiment::to_tsv(averages_of(table))}, {name + ".gp", script}}};
}

}  // namespace amiss::app
