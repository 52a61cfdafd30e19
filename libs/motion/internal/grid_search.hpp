// Dijkstra over the passable cells of a DriveMap, 16 neighbours, buckets of one cell's width (Dial 1969, Dinitz 1978):
// no edge is shorter than a bucket is wide, so within a bucket the order does not matter.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "motion/drive_map.hpp"

namespace amiss::motion::internal {

struct SearchField {
  std::vector<float> cost_m;            // infinite where there is no way
  std::vector<std::uint8_t> came_from;  // index of the move that led here
};

constexpr std::uint8_t kNoMove = 255;

struct SearchLimits {
  double clearance_weight = 0.0;  // 0: lengths; else a metre at the robot's radius costs 1 + this
  std::optional<Cell> goal;       // stop when it is settled
};

/// What a metre costs at a clearance, from 1 at the preferred clearance to 1 + weight at the robot's radius.
[[nodiscard]] inline float weight_at(const DriveParams& params, double clearance_weight, float clearance_m) {
  const double lack = params.preferred_clearance_m - static_cast<double>(clearance_m);
  const double range = params.preferred_clearance_m - params.robot_radius_m;
  if (lack <= 0.0 || range <= 0.0) return 1.0F;
  return static_cast<float>(1.0 + clearance_weight * std::min(1.0, lack / range));
}

[[nodiscard]] SearchField search(const DriveMap& map, Cell start, float start_cost_m, const SearchLimits& limits);

/// Cells from the start of the search to `c`; empty where there is no way.
[[nodiscard]] std::vector<Cell> trace(const FloorGrid& grid, const SearchField& field, Cell c);

}  // namespace amiss::motion::internal
