// Lengths of the shortest ways from one place to all others, over cells that the robot's centre can be in.
// DriveMap, place in the map frame -> metres (infinite where there is no way) and the way itself.
// Dijkstra over 16 neighbours in buckets (Dial 1969): at most 2.8 % longer than the shortest way in the open.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "motion/drive_map.hpp"
#include "motion/internal/grid_search.hpp"

namespace amiss::motion {

class PathLengths {
 public:
  static constexpr float kUnreachable = std::numeric_limits<float>::infinity();

  /// Begins at the passable cell nearest to `from` within `escape_m`; with none nothing is reachable.
  PathLengths(const DriveMap& map, const Eigen::Vector2d& from_map, double escape_m = 0.5);

  [[nodiscard]] float to(const Eigen::Vector2d& p_map) const { return to(geometry_.cell_at(p_map)); }
  [[nodiscard]] float to(Cell c) const {
    return geometry_.contains(c) ? field_.cost_m[geometry_.index(c)] : kUnreachable;
  }
  /// The cell nearest to the place, within `tolerance_m`, that a way leads to.
  [[nodiscard]] std::optional<Cell> nearest(const Eigen::Vector2d& p_map, double tolerance_m) const;
  /// The way to that cell and from there to the place.
  [[nodiscard]] float near(const Eigen::Vector2d& p_map, double tolerance_m) const;
  /// Row-major as the grid of the map; what the functions of `view` call travel_m.
  [[nodiscard]] std::span<const float> field() const { return field_.cost_m; }
  /// Cell centres from the beginning to the place; empty where there is no way.
  [[nodiscard]] std::vector<Eigen::Vector2d> way_to(const Eigen::Vector2d& p_map) const;

 private:
  FloorGrid geometry_;
  internal::SearchField field_;
};

/// Way lengths between all places (row-major n x n, symmetric), infinite where there is none; each place may be moved
/// by `tolerance_m` to where the robot can be, and one that can be reached from the first place is moved to where that
/// is so, even when there is a nearer pocket that nobody can get into.
[[nodiscard]] std::vector<double> way_matrix(const DriveMap& map, std::span<const Eigen::Vector2d> places_map,
                                             double tolerance_m = 0.5);

}  // namespace amiss::motion
