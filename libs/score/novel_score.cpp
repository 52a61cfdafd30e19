#include "score/novel_score.hpp"

#include <algorithm>
#include <cmath>

namespace amiss::score {

namespace {

PointSet united(const std::vector<PointSet>& sets) {
  PointSet all;
  for (const PointSet& set : sets) all.insert(all.end(), set.begin(), set.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// Positions of the sets that have no point in `points` (ascending).
std::vector<std::size_t> without_a_point_in(const std::vector<PointSet>& sets, const PointSet& points) {
  std::vector<std::size_t> positions;
  for (std::size_t k = 0; k < sets.size(); ++k) {
    const bool touches = std::any_of(sets[k].begin(), sets[k].end(), [&](std::uint32_t i) {
      return std::binary_search(points.begin(), points.end(), i);
    });
    if (!touches) positions.push_back(k);
  }
  return positions;
}

MeanAndDeviation statistics_of(const std::vector<double>& values) {
  MeanAndDeviation out;
  if (values.empty()) return out;
  const auto n = static_cast<double>(values.size());
  for (const double v : values) out.mean += v / n;
  double squares = 0.0;
  for (const double v : values) squares += (v - out.mean) * (v - out.mean);
  out.deviation = std::sqrt(squares / n);
  return out;
}

template <class Name>
std::vector<std::string> names_in_order(const std::vector<NovelTrial>& trials, Name name) {
  std::vector<std::string> names;
  for (const NovelTrial& trial : trials) {
    if (std::find(names.begin(), names.end(), trial.*name) == names.end()) names.push_back(trial.*name);
  }
  return names;
}

/// The trials of a method, in one room or (room empty) in all.
NovelRow row_of(const std::vector<NovelTrial>& trials, const std::string& room, const std::string& method) {
  std::vector<double> precision, recall, f1;
  NovelRow row{room, method, {}, {}, {}, 0.0, 0.0};
  for (const NovelTrial& trial : trials) {
    if (trial.method != method || (!room.empty() && trial.room != room)) continue;
    precision.push_back(trial.precision);
    recall.push_back(trial.recall);
    f1.push_back(trial.f1);
    row.missed += trial.missed;
    row.wrong += trial.wrong;
  }
  row.precision = statistics_of(precision);
  row.recall = statistics_of(recall);
  row.f1 = statistics_of(f1);
  return row;
}

NovelRow average_of(const std::vector<NovelTrial>& trials, const std::vector<NovelRow>& rows,
                    const std::string& method) {
  NovelRow average = row_of(trials, "", method);  // for the deviations
  average.room = "average";
  std::vector<double> precision, recall, f1, missed, wrong;
  for (const NovelRow& row : rows) {
    if (row.method != method) continue;
    precision.push_back(row.precision.mean);
    recall.push_back(row.recall.mean);
    f1.push_back(row.f1.mean);
    missed.push_back(row.missed);
    wrong.push_back(row.wrong);
  }
  average.precision.mean = statistics_of(precision).mean;
  average.recall.mean = statistics_of(recall).mean;
  average.f1.mean = statistics_of(f1).mean;
  average.missed = statistics_of(missed).mean;
  average.wrong = statistics_of(wrong).mean;
  return average;
}

}  // namespace

NovelScore score_novel(const std::vector<PointSet>& found, const std::vector<PointSet>& objects) {
  const PointSet detected = united(found), annotated = united(objects);
  PointSet both;
  std::set_intersection(detected.begin(), detected.end(), annotated.begin(), annotated.end(), std::back_inserter(both));
  NovelScore score;
  score.true_points = both.size();
  score.found_points = detected.size();
  score.annotated_points = annotated.size();
  const auto hits = static_cast<double>(both.size());
  const double nothing_to_find = annotated.empty() ? 1.0 : 0.0;
  score.precision = detected.empty() ? nothing_to_find : hits / static_cast<double>(detected.size());
  score.recall = annotated.empty() ? 1.0 : hits / static_cast<double>(annotated.size());
  const double sum = score.precision + score.recall;
  score.f1 = sum > 0.0 ? 2.0 * score.precision * score.recall / sum : 0.0;
  score.missed = without_a_point_in(objects, detected);
  score.wrong = without_a_point_in(found, annotated);
  return score;
}

std::vector<NovelRow> table52(const std::vector<NovelTrial>& trials) {
  const std::vector<std::string> methods = names_in_order(trials, &NovelTrial::method);
  std::vector<NovelRow> rows;
  for (const std::string& room : names_in_order(trials, &NovelTrial::room)) {
    for (const std::string& method : methods) rows.push_back(row_of(trials, room, method));
  }
  const std::vector<NovelRow> of_rooms = rows;
  for (const std::string& method : methods) rows.push_back(average_of(trials, of_rooms, method));
  return rows;
}

}  // namespace amiss::score
