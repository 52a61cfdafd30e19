#include "motion/drive_map.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace amiss::motion {
namespace {

constexpr double kBeyond_m = 1.0;  // round what the reference knows, where layers still count

template <class Visit>
void for_cells(const CellBox& box, Visit visit) {
  for (int y = box.low.y; y <= box.high.y; ++y) {
    for (int x = box.low.x; x <= box.high.x; ++x) visit(Cell{x, y});
  }
}

CellBox grown(const CellBox& box, int cells, const FloorGrid& grid) {
  return {{std::max(0, box.low.x - cells), std::max(0, box.low.y - cells)},
          {std::min(grid.width() - 1, box.high.x + cells), std::min(grid.height() - 1, box.high.y + cells)}};
}

void add(CellBox& box, Cell c) {
  if (box.high.x < box.low.x) box = {c, c};
  box.low = {std::min(box.low.x, c.x), std::min(box.low.y, c.y)};
  box.high = {std::max(box.high.x, c.x), std::max(box.high.y, c.y)};
}

constexpr CellBox kEmpty{{0, 0}, {-1, -1}};

CellBox known_box(const FloorGrid& grid) {
  CellBox box = kEmpty;
  for (int y = 0; y < grid.height(); ++y) {
    const Occupancy* row = grid.cells().data() + grid.index({0, y});
    const Occupancy* end = row + grid.width();
    const auto known = [](Occupancy o) { return o != Occupancy::kUnknown; };
    const Occupancy* first = std::find_if(row, end, known);
    if (first == end) continue;
    const Occupancy* last = end - 1;
    while (*last == Occupancy::kUnknown) --last;
    add(box, {static_cast<int>(first - row), y});
    add(box, {static_cast<int>(last - row), y});
  }
  return box;
}

void merge_value(FloorGrid& merged, Cell c, Occupancy there) {
  if (there == Occupancy::kOccupied || (there == Occupancy::kFree && merged.at(c) == Occupancy::kUnknown)) {
    merged.set(c, there);
  }
}

bool same_geometry(const FloorGrid& a, const FloorGrid& b) {
  return a.width() == b.width() && a.height() == b.height() && a.resolution_m() == b.resolution_m() &&
         a.origin_m() == b.origin_m();
}

/// Occupied wins, free fills what is unknown.
void merge_layer(FloorGrid& merged, const FloorGrid& layer, const CellBox& box) {
  if (same_geometry(merged, layer)) {
    for_cells(box, [&](Cell c) { merge_value(merged, c, layer.at(c)); });
    return;
  }
  for_cells(box, [&](Cell c) { merge_value(merged, c, layer.at(merged.centre_of(c))); });
  // A finer layer has cells that hold no centre of ours.
  for_cells({{0, 0}, {layer.width() - 1, layer.height() - 1}}, [&](Cell theirs) {
    if (layer.at(theirs) != Occupancy::kOccupied) return;
    const Cell ours = merged.cell_at(layer.centre_of(theirs));
    const bool inside = ours.x >= box.low.x && ours.y >= box.low.y && ours.x <= box.high.x && ours.y <= box.high.y;
    if (inside) merged.set(ours, Occupancy::kOccupied);
  });
}

/// Nothing is free outside of the box, wherever the robot believes to stand.
void free_disc(FloorGrid& grid, const CellBox& box, const Eigen::Vector2d& place, double radius_m) {
  const Cell low = grid.cell_at(place - Eigen::Vector2d::Constant(radius_m));
  const Cell high = grid.cell_at(place + Eigen::Vector2d::Constant(radius_m));
  for (int y = std::max(low.y, box.low.y); y <= std::min(high.y, box.high.y); ++y) {
    for (int x = std::max(low.x, box.low.x); x <= std::min(high.x, box.high.x); ++x) {
      const Cell c{x, y};
      if ((grid.centre_of(c) - place).norm() <= radius_m) grid.set(c, Occupancy::kFree);
    }
  }
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
  scratch_ = reference_;
  passable_from_m_ = static_cast<float>(params_.robot_radius_m - 1e-6);
  clearance_m_.assign(grid_.cells().size(), 0.0F);
  box_ = known_box(reference_);
  if (box_.width() <= 0) return;
  box_ = grown(box_, static_cast<int>(std::ceil(kBeyond_m / grid_.resolution_m())), grid_);
  recompute(box_);
}

std::size_t DriveMap::update(std::span<const FloorGrid* const> layers, std::span<const Eigen::Vector2d> hits_map) {
  for_cells(box_, [&](Cell c) { scratch_.set(c, reference_.at(c)); });
  for (const FloorGrid* layer : layers) merge_layer(scratch_, *layer, box_);
  add_hits(hits_map);
  for (const Eigen::Vector2d& place : free_places_) free_disc(scratch_, box_, place, free_radius_m_);
  CellBox changed = kEmpty;
  std::size_t changes = 0;
  for_cells(box_, [&](Cell c) {
    if (grid_.at(c) == scratch_.at(c)) return;
    ++changes;
    add(changed, c);
  });
  std::swap(grid_, scratch_);
  if (changes > 0) recompute(changed);
  return changes;
}

void DriveMap::add_hits(std::span<const Eigen::Vector2d> hits_map) {
  std::vector<Cell> news;
  for (const Eigen::Vector2d& hit : hits_map) {
    const Cell c = scratch_.cell_at(hit);
    if (c.x < box_.low.x || c.y < box_.low.y || c.x > box_.high.x || c.y > box_.high.y) continue;
    bool known = false;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) known = known || scratch_.at(Cell{c.x + dx, c.y + dy}) == Occupancy::kOccupied;
    }
    if (!known) news.push_back(c);
  }
  for (const Cell c : news) scratch_.set(c, Occupancy::kOccupied);
}

void DriveMap::keep_free(std::vector<Eigen::Vector2d> places_map, double radius_m) {
  free_places_ = std::move(places_map);
  free_radius_m_ = radius_m;
}

/// A change reaches as far as the cap; what is nearest to a cell there lies within a second cap.
void DriveMap::recompute(const CellBox& changed) {
  const double half_cell_m = 0.5 * grid_.resolution_m();
  const int reach = static_cast<int>(std::ceil((params_.clearance_cap_m + half_cell_m) / grid_.resolution_m()));
  const CellBox outer = grown(changed, 2 * reach, grid_), inner = grown(changed, reach, grid_);
  const Eigen::Vector2d origin = grid_.origin_m() + grid_.resolution_m() * Eigen::Vector2d(outer.low.x, outer.low.y);
  FloorGrid window(grid_.resolution_m(), origin, outer.width(), outer.height());
  for_cells(outer, [&](Cell c) { window.set({c.x - outer.low.x, c.y - outer.low.y}, grid_.at(c)); });
  const std::vector<float> distance_m = distance_to_occupied_m(window, params_.unknown_is_occupied);
  const auto half = static_cast<float>(half_cell_m), cap = static_cast<float>(params_.clearance_cap_m);
  for_cells(inner, [&](Cell c) {
    const float d = distance_m[window.index({c.x - outer.low.x, c.y - outer.low.y})];
    clearance_m_[grid_.index(c)] = std::clamp(d - half, 0.0F, cap);
  });
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
