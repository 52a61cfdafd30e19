// How well novel objects were found in a reconstruction, and the rows of Table 5.2 (Section 5.3.4, 5.3.5).
//
// in: indices of points of the current cloud: the clusters that a method found, the objects as annotated
// out: precision, recall and F1 over all points, the objects of which no point was found (missed), the clusters that
// hold no point of any object (wrong); rows with mean and standard deviation (of the population) over the visits of a
// room, missed and wrong summed. A point that stands twice counts once.
// Where the quotients are not defined: without any object recall is 1, and precision is 1 when nothing was found; with
// objects and nothing found precision is 0. F1 is 0 where both are 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace amiss::score {

using PointSet = std::vector<std::uint32_t>;

struct NovelScore {
  double precision = 0.0, recall = 0.0, f1 = 0.0;
  std::size_t true_points = 0, found_points = 0, annotated_points = 0;
  std::vector<std::size_t> missed;  // positions in `objects`
  std::vector<std::size_t> wrong;   // positions in `found`
};

[[nodiscard]] NovelScore score_novel(const std::vector<PointSet>& found, const std::vector<PointSet>& objects);

/// The score of one method on one visit.
struct NovelTrial {
  std::string room, method;
  double precision = 0.0, recall = 0.0, f1 = 0.0;
  double missed = 0.0, wrong = 0.0;
};

struct MeanAndDeviation {
  double mean = 0.0, deviation = 0.0;
};

struct NovelRow {
  std::string room, method;
  MeanAndDeviation precision, recall, f1;
  double missed = 0.0, wrong = 0.0;  // summed over the visits; of `average`: their means over the rooms
};

/// Rooms and methods in the order in which they come; the room `average` last: the means of the rooms' rows, the
/// deviations over all visits, as in the thesis.
[[nodiscard]] std::vector<NovelRow> table52(const std::vector<NovelTrial>& trials);

}  // namespace amiss::score
