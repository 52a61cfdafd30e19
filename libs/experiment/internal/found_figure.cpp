#include "experiment/internal/found_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "experiment/comparison.hpp"
#include "experiment/internal/gnuplot_script.hpp"
#include "experiment/table.hpp"

namespace amiss::experiment {

namespace {

using report::SegmentationTimes;

struct Panel {
  int objects = 0;
  const SegmentationTimes* times = nullptr;

  [[nodiscard]] std::string name() const {
    return fmt::format("{} object{}, {}", objects, objects == 1 ? "" : "s", times->name);
  }
};

std::vector<Panel> panels_of(const Spec& spec, const FigureSpec& figure) {
  std::vector<Panel> panels;
  for (const SegmentationTimes& times : report::kSegmentationTimes) {
    if (std::find(figure.times.begin(), figure.times.end(), times.name) == figure.times.end()) continue;
    for (const int objects : spec.objects) panels.push_back({objects, &times});
  }
  return panels;
}

/// Of each trial of a method in a panel, when it found its objects.
using Moments = std::vector<std::vector<double>>;

Moments moments_of(const std::vector<TrialResult>& results, const Panel& panel, const std::string& method) {
  Moments moments;
  for (const TrialResult& r : results) {
    if (r.trial.objects == panel.objects && r.trial.method == method) moments.push_back(found_at_s(r, *panel.times));
  }
  return moments;
}

Quartiles found_until(const Moments& moments, double at_s) {
  std::vector<double> counts;
  for (const auto& trial : moments) {
    counts.push_back(static_cast<double>(std::upper_bound(trial.begin(), trial.end(), at_s) - trial.begin()));
  }
  return quartiles(counts);
}

/// Steps as corners: the value before and the value after each moment.
void add_steps(Table& table, const Panel& panel, const std::string& method, const Moments& moments, double end_s) {
  std::set<double> changes;
  for (const auto& trial : moments) changes.insert(trial.begin(), trial.end());
  changes.insert(end_s);
  Quartiles before;
  const auto add = [&](double at_s, const Quartiles& q) {
    table.rows.push_back(
        {panel.name(), method, number_text(at_s), number_text(q.q1), number_text(q.median), number_text(q.q3)});
  };
  add(0.0, before);
  for (const double at_s : changes) {
    const Quartiles after = found_until(moments, at_s);
    add(at_s, before);
    add(at_s, after);
    before = after;
  }
}

double end_of(const std::vector<TrialResult>& results, const Panel& panel) {
  double end_s = 1.0;
  for (const TrialResult& r : results) {
    const auto found = found_at_s(r, *panel.times);
    if (r.trial.objects == panel.objects && !found.empty()) end_s = std::max(end_s, found.back());
  }
  return 1.05 * end_s;
}

std::string plot_of(const Spec& spec, const FigureSpec& figure, const Panel& panel) {
  std::vector<std::string> bands, lines;
  for (const std::string& method : spec.methods) {
    const std::string mine =
        fmt::format("strcol('panel') eq {} && strcol('method') eq {}", in_quotes(panel.name()), in_quotes(method));
    const Paint paint = paint_of(method, false);
    bands.push_back(fmt::format(
        "'{}.tsv' using (column('at_s')):({} ? column('q1') : NaN):(column('q3')) with filledcurves fs transparent "
        "solid 0.2 noborder lc rgb '{}' notitle",
        figure.name, mine, paint.colour));
    lines.push_back(fmt::format(
        "'{}.tsv' using (column('at_s')):({} ? column('median') : NaN) with lines lw 2 dt {} lc rgb '{}' title {}",
        figure.name, mine, method == report::kDynamic ? "solid" : "2", paint.colour, in_quotes(method)));
  }
  bands.insert(bands.end(), lines.begin(), lines.end());
  return fmt::format("set title {}\nset yrange [0:{}]\nplot {}\n", in_quotes(panel.name()), panel.objects + 0.3,
                     fmt::join(bands, ", \\\n     "));
}

}  // namespace

Figure found_figure(const Spec& spec, const FigureSpec& figure, const std::vector<TrialResult>& results) {
  Table table{{"panel", "method", "at_s", "q1", "median", "q3"}, {}};
  const std::vector<Panel> panels = panels_of(spec, figure);
  std::string plots;
  for (const Panel& panel : panels) {
    const double end_s = end_of(results, panel);
    for (const std::string& method : spec.methods) {
      const Moments moments = moments_of(results, panel, method);
      if (!moments.empty()) add_steps(table, panel, method, moments, end_s);
    }
    plots += fmt::format("set xrange [0:{}]\n", number_text(end_s)) + plot_of(spec, figure, panel);
  }
  const std::size_t columns = panels.size() > 1 ? 2 : 1;
  const std::string script =
      script_head(figure.name) + "set xlabel 'simulated time (s)'\nset ylabel 'objects found'\nset ytics 1\n" +
      "set key bottom right opaque\n" +
      fmt::format("set multiplot layout {},{} title {}\n", (panels.size() + columns - 1) / columns, columns,
                  in_quotes(figure.title + ": median and quartiles")) +
      plots + "unset multiplot\n";
  return {figure.name, figure.title, {{figure.name + ".tsv", to_tsv(table)}, {figure.name + ".gp", script}}};
}

}  // namespace amiss::experiment
