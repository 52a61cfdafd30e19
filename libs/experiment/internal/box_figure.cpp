#include "experiment/internal/box_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiment/comparison.hpp"
#include "experiment/internal/gnuplot_script.hpp"
#include "experiment/table.hpp"

namespace amiss::experiment {

namespace {

constexpr double kWhisker = 1.5;  // Tukey 1977

/// Boxes of one colour: a method, and with which times.
struct Series {
  std::string name, method, measure;
  Paint paint;
};

std::vector<Series> series_of(const Spec& spec, const FigureSpec& figure) {
  std::vector<Series> series;
  if (figure.shows == FigureSpec::Shows::kSegmentations) {
    for (const std::string& m : spec.methods) series.push_back({m, m, measures().front(), paint_of(m, false)});
    return series;
  }
  for (const std::string& name : figure.times) {
    for (const report::SegmentationTimes& times : report::kSegmentationTimes) {
      if (times.name != name) continue;
      for (const std::string& m : spec.methods) {
        series.push_back({fmt::format("{}, {} s a segmentation", m, report::action_s(times, m)), m, time_measure(name),
                          paint_of(m, name != figure.times.front())});
      }
    }
  }
  return series;
}

/// Infinite ones stay off the drawing.
double within(double value, double highest) { return std::min(value, highest); }

struct Blocks {
  Table points{{"series", "x", "objects", "seed", "value"}, {}};
  Table boxes{{"series", "x", "objects", "trials", "not_all_found", "low", "q1", "median", "q3", "high", "note"}, {}};
};

void add_box(Blocks& blocks, const Series& series, double x, int objects, const Sample& sample, double highest) {
  const Quartiles q = quartiles(sample.values);
  const double reach = kWhisker * (q.q3 - q.q1);
  double low = q.q1, high = q.q3;
  std::size_t infinite = 0;
  for (std::size_t i = 0; i < sample.values.size(); ++i) {
    const double value = sample.values[i];
    if (!std::isfinite(value)) {
      ++infinite;
      continue;
    }
    if (!(value < q.q1 - reach)) low = std::min(low, value);
    if (!(value > q.q3 + reach)) high = std::max(high, value);
    const double spread = 0.25 * (static_cast<double>(i) + 0.5) / static_cast<double>(sample.values.size()) - 0.125;
    blocks.points.rows.push_back({series.name, number_text(x + spread * 0.5), std::to_string(objects),
                                  std::to_string(sample.seeds[i]), number_text(value)});
  }
  std::vector<std::string> row{series.name, number_text(x), std::to_string(objects),
                               std::to_string(sample.values.size()), std::to_string(infinite)};
  for (const double v : {low, q.q1, q.median, q.q3, high}) row.push_back(number_text(within(v, highest)));
  row.push_back(infinite == 0 ? "-" : fmt::format("{} of {} not all", infinite, sample.values.size()));
  blocks.boxes.rows.push_back(std::move(row));
}

double highest_of(const std::vector<TrialResult>& results, const std::vector<Series>& series) {
  double highest = 0.0;
  for (const TrialResult& r : results) {
    for (const Series& s : series) {
      const double value = r.trial.method == s.method ? measured(r, s.measure) : 0.0;
      if (std::isfinite(value)) highest = std::max(highest, value);
    }
  }
  return highest > 0.0 ? 1.1 * highest : 1.0;
}

std::string tics_of(const Spec& spec) {
  std::vector<std::string> tics;
  for (std::size_t i = 0; i < spec.objects.size(); ++i) tics.push_back(fmt::format("'{}' {}", spec.objects[i], i));
  return fmt::format("set xtics ({}) scale 0\n", fmt::join(tics, ", "));
}

std::string plot_of(const std::string& name, const std::vector<Series>& series) {
  std::vector<std::string> parts;
  const auto one_of = [](const Series& s, const char* x) {
    return fmt::format("(strcol('series') eq {} ? column({}) : NaN)", in_quotes(s.name), x);
  };
  for (const Series& s : series) {
    parts.push_back(fmt::format(
        "'{0}_boxes.tsv' using {1}:'q1':'low':'high':'q3' with candlesticks whiskerbars 0.5 lw 1.5 lc rgb '{2}' "
        "fs solid 0.3 border lc rgb '{2}' title {3}",
        name, one_of(s, "'x'"), s.paint.colour, in_quotes(s.name)));
  }
  for (const Series& s : series) {
    parts.push_back(fmt::format("'{}.tsv' using {}:'value' with points pt {} ps 0.6 lc rgb '{}' notitle", name,
                                one_of(s, "'x'"), s.paint.point, s.paint.colour));
  }
  parts.push_back(fmt::format(
      "'{}_boxes.tsv' using 'x':'median':'median':'median':'median' with candlesticks lw 2.5 lc rgb '#000000' notitle",
      name));
  parts.push_back(fmt::format(
      "'' using (column('x')):(column('high')):(strcol('note') eq '-' ? '' : strcol('note')) with labels offset 0,0.8 "
      "font ',9' notitle"));
  return fmt::format("plot {}\n", fmt::join(parts, ", \\\n     "));
}

}  // namespace

Figure box_figure(const Spec& spec, const FigureSpec& figure, const std::vector<TrialResult>& results) {
  const std::vector<Series> series = series_of(spec, figure);
  const double highest = highest_of(results, series), step = 0.8 / static_cast<double>(series.size());
  Blocks blocks;
  for (std::size_t group = 0; group < spec.objects.size(); ++group) {
    for (std::size_t i = 0; i < series.size(); ++i) {
      const Cell cell = cell_of(results, figure.world, spec.objects[group], series[i].measure);
      const Sample* sample = cell.sample(series[i].method);
      const double x = static_cast<double>(group) - 0.4 + step * (static_cast<double>(i) + 0.5);
      if (sample != nullptr) add_box(blocks, series[i], x, spec.objects[group], *sample, highest);
    }
  }
  const bool is_time = figure.shows == FigureSpec::Shows::kTime;
  const std::string script =
      script_head(figure.name) +
      fmt::format("set title {}\nset xlabel 'objects in the environment'\nset ylabel '{}'\n", in_quotes(figure.title),
                  is_time ? "time to find all objects (s, simulated)" : "segmentation actions to find all objects") +
      tics_of(spec) +
      fmt::format("set xrange [-0.5:{}]\nset yrange [0:{}]\nset key above Left reverse\nset boxwidth {}\n",
                  static_cast<double>(spec.objects.size()) - 0.5, number_text(1.15 * highest),
                  number_text(0.8 * step)) +
      plot_of(figure.name, series);
  return {figure.name,
          figure.title,
          {{figure.name + ".tsv", to_tsv(blocks.points)},
           {figure.name + "_boxes.tsv", to_tsv(blocks.boxes)},
           {figure.name + ".gp", script}}};
}

}  // namespace amiss::experiment
