#include "motion/drive_map.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace amiss::motion {
namespace {

/// Cells of the layer that lie in the box become cells of `merged`: occupied wins, free fills what is unknown.
void merge_layer(FloorGrid& merged, const FloorGrid& layer) {
  for (int y = 0; y < merged.height(); ++y) {
    for (int x = 0; x < merged.width(); ++x) {
      const Occupancy there = layer.at(merged.centre_of({x, y}));
      if (there == Occupancy::kUnknown) continue;
      if (there == Occupancy::kOccupied || merged.at(Cell{x, y}) == Occupancy::kUnknown) merged.set({x, y}, there);
    }
  }
  // A finer layer has cells that hold no centre of ours.
  for (int y = 0; y < layer.height(); ++y) {
    for (int x = 0; x < layer.width(); ++x) {
      if (layer.at(Cell{x, y}) != Occupancy::kOccupied) continue;
      const Cell ours = merged.cell_at(layer.centre_of({x, y}));
      if (merged.contains(ours)) merged.set(ours, Occupancy::kOccupied);
    }
  }
}

bool same_geometry(const FloorGrid& a, const FloorGrid& b) {
  return a.width() == b.width() && a.height() == b.height() && a.resolution_m() == b.resolution_m() &&
         a.origin_m() == b.origin_m();
}

void merge_equal(FloorGrid& merged, const FloorGrid& layer) {
  for (int y = 0; y < merged.height(); ++y) {
    for (int x = 0; x < merged.width(); ++x) {
      const Cell c{x, y};
      const Occupancy there = layer.at(c);
      if (there == Occupancy::kOccupied || (there == Occupancy::kFree && merged.at(c) == Occupancy::kUnknown)) {
        merged.set(c, there);
      }
    }
  }
}

void free_disc(FloorGrid& grid, const Eigen::Vector2d& place, double radius_m) {
  const Cell low = grid.cell_at(place - Eigen::Vector2d::Constant(radius_m));
  const Cell high = grid.cell_at(place + Eigen::Vector2d::Constant(radius_m));
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      const Cell c{x, y};
      if (grid.contains(c) && (grid.centre_of(c) - place).norm() <= radius_m) grid.set(c, Occupancy::kFree);
    }
  }
}

struct Box {
  Cell low, high;  // both inside
};

std::size_t count_changes(const FloorGrid& before, const FloorGrid& after, Box& box) {
  std::size_t changes = 0;
  for (int y = 0; y < after.height(); ++y) {
    for (int x = 0; x < after.width(); ++x) {
      if (before.at(Cell{x, y}) == after.at(Cell{x, y})) continue;
      if (changes++ == 0) box = {{x, y}, {x, y}};
      box.low = {std::min(box.low.x, x), std::min(box.low.y, y)};
      box.high = {std::max(box.high.x, x), std::max(box.high.y, y)};
    }
  }
  return changes;
}

}  // namespace

void describe(ParamTable& table, DriveParams& p) {
  table.number("drive.robot_radius", p.robot_radius_m, "m", 0.1, 1.0, "clearance that a path keeps");
  table.number("drive.preferred_clearance", p.preferred_clearance_m, "m", 0.1, 2.0, "clearance that a path prefers");
  table.number("drive.clearance_cap", p.clearance_cap_m, "m", 0.5, 5.0, "clearance above this is not told apart");
  table.flag("drive.unknown_is_occupied", p.unknown_is_occupied, "paths keep their distance from unknown space too");
}

DriveMap::DriveMap(FloorGrid reference, DriveParams params) : params_(params) { reset(std::move(reference)); }

void DriveMap::reset(FloorGrid reference) {
  reference_ = std::move(reference);
  grid_ = reference_;
  passable_from_m_ = static_cast<float>(params_.robot_radius_m - 1e-6);
  clearance_m_.assign(grid_.cells().size(), 0.0F);
  if (!clearance_m_.empty()) recompute({0, 0}, {grid_.width() - 1, grid_.height() - 1});
}

std::size_t DriveMap::update(std::span<const FloorGrid* const> layers, std::span<const Eigen::Vector2d> hits_map) {
  scratch_ = reference_;
  for (const FloorGrid* layer : layers) {
    if (same_geometry(scratch_, *layer)) {
      merge_equal(scratch_, *layer);
    } else {
      merge_layer(scratch_, *layer);
    }
  }
  for (const Eigen::Vector2d& hit : hits_map) {
    const Cell c = scratch_.cell_at(hit);
    if (scratch_.contains(c)) scratch_.set(c, Occupancy::kOccupied);
  }
  for (const Eigen::Vector2d& place : free_places_) free_disc(scratch_, place, free_radius_m_);
  Box changed;
  const std::size_t changes = count_changes(grid_, scratch_, changed);
  std::swap(grid_, scratch_);
  if (changes > 0) recompute(changed.low, changed.high);
  return changes;
}

void DriveMap::keep_free(std::vector<Eigen::Vector2d> places_map, double radius_m) {
  free_places_ = std::move(places_map);
  free_radius_m_ = radius_m;
}

/// A change reaches as far as the cap; what is nearest to a cell there lies within a second cap.
void DriveMap::recompute(Cell low, Cell high) {
  const double half_cell_m = 0.5 * grid_.resolution_m();
  const int reach = static_cast<int>(std::ceil((params_.clearance_cap_m + half_cell_m) / grid_.resolution_m()));
  const auto grown = [&](int cells) {
    return Box{{std::max(0, low.x - cells), std::max(0, low.y - cells)},
               {std::min(grid_.width() - 1, high.x + cells), std::min(grid_.height() - 1, high.y + cells)}};
  };
  const Box outer = grown(2 * reach), inner = grown(reach);
  const Eigen::Vector2d origin =
      grid_.origin_m() + grid_.resolution_m() * Eigen::Vector2d(double(outer.low.x), double(outer.low.y));
  FloorGrid window(grid_.resolution_m(), origin, outer.high.x - outer.low.x + 1, outer.high.y - outer.low.y + 1);
  for (int y = 0; y < window.height(); ++y) {
    for (int x = 0; x < window.width(); ++x) window.set({x, y}, grid_.at(Cell{outer.low.x + x, outer.low.y + y}));
  }
  const std::vector<float> distance_m = distance_to_occupied_m(window, params_.unknown_is_occupied);
  const auto half = static_cast<float>(half_cell_m), cap = static_cast<float>(params_.clearance_cap_m);
  for (int y = inner.low.y; y <= inner.high.y; ++y) {
    for (int x = inner.low.x; x <= inner.high.x; ++x) {
      const float d = distance_m[window.index({x - outer.low.x, y - outer.low.y})];
      clearance_m_[grid_.index({x, y})] = std::clamp(d - half, 0.0F, cap);
    }
  }
}

double DriveMap::clearance_at(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2d at = (p_map - grid_.origin_m()) / grid_.resolution_m() - Eigen::Vector2d::Constant(0.5);
  const double x = std::floor(at.x()), y = std::floor(at.y());
  if (!(std::abs(x) < 1e9) || !(std::abs(y) < 1e9)) return 0.0;
  const Cell c{static_cast<int>(x), static_cast<int>(y)};
  const double fx = at.x() - x, fy = at.y() - y;
  const auto value = [&](int dx, int dy) { return static_cast<double>(clearance_at(Cell{c.x + dx, c.y + dy})); };
  return (1 - fy) * ((1 - fx) * value(0, 0) + fx * value(1, 0)) + fy * ((1 - fx) * value(0, 1) + fx * value(1, 1));
}

std::optional<Cell> DriveMap::nearest_passable(const Eigen::Vector2d& p_map, double radius_m) const {
  const Cell middle = grid_.cell_at(p_map);
  if (grid_.contains(middle) && passable(middle)) return middle;
  const int reach = static_cast<int>(std::ceil(radius_m / grid_.resolution_m()));
  std::optional<Cell> nearest;
  double nearest_m = radius_m;
  for (int y = std::max(0, middle.y - reach); y <= std::min(grid_.height() - 1, middle.y + reach); ++y) {
    for (int x = std::max(0, middle.x - reach); x <= std::min(grid_.width() - 1, middle.x + reach); ++x) {
      if (!passable({x, y})) continue;
      const double d = (grid_.centre_of({x, y}) - p_map).norm();
      if (d > nearest_m || (nearest && d == nearest_m)) continue;
      nearest = Cell{x, y};
      nearest_m = d;
    }
  }
  return nearest;
}

std::vector<Eigen::Vector2d> laser_hits(const LaserScan& scan, const Pose2<Map, Base>& T_map_base,
                                        const Transform<Base, Laser>& T_base_laser, double max_range_m) {
  const double c = std::cos(T_map_base.yaw_rad), s = std::sin(T_map_base.yaw_rad);
  std::vector<Eigen::Vector2d> hits = laser_hits(scan, T_base_laser, max_range_m);
  for (Eigen::Vector2d& p : hits) {
    p = T_map_base.position() + Eigen::Vector2d(c * p.x() - s * p.y(), s * p.x() + c * p.y());
  }
  return hits;
}

std::vector<Eigen::Vector2d> laser_hits(const LaserScan& scan, const Transform<Base, Laser>& T_base_laser,
                                        double max_range_m) {
  const double limit_m = std::min(max_range_m, scan.max_range_m);
  std::vector<Eigen::Vector2d> hits;
  hits.reserve(scan.ranges_m.size());
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    const auto range_m = static_cast<double>(scan.ranges_m[i]);
    if (!(range_m >= scan.min_range_m && range_m <= limit_m)) continue;  // NaN is neither
    const double angle = scan.angle_min_rad + static_cast<double>(i) * scan.angle_step_rad;
    const Eigen::Vector3d p_laser(range_m * std::cos(angle), range_m * std::sin(angle), 0.0);
    hits.emplace_back((T_base_laser.T * p_laser).head<2>());
  }
  return hits;
}

}  // namespace amiss::motion
