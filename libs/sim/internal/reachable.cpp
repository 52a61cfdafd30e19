#include "sim/internal/reachable.hpp"

#include <algorithm>
#include <cmath>

#include "sim/free_space.hpp"

namespace amiss::sim::internal {
namespace {

constexpr double kNearStart_m = 0.5;
constexpr double kPocket_m2 = 0.02;  // so little may be cut off: a corner that the disc could just poke into

/// Calls `visit` for the cells whose centres lie within a radius of p.
template <class Visit>
void for_cells_within(const FloorGrid& grid, const Eigen::Vector2d& p, double radius_m, Visit visit) {
  const Cell low = grid.cell_at(p.array() - radius_m), high = grid.cell_at(p.array() + radius_m);
  for (int y = std::max(0, low.y); y <= std::min(grid.height() - 1, high.y); ++y) {
    for (int x = std::max(0, low.x); x <= std::min(grid.width() - 1, high.x); ++x) {
      const double distance_m = (grid.centre_of({x, y}) - p).norm();
      if (distance_m <= radius_m) visit(Cell{x, y}, distance_m);
    }
  }
}

}  // namespace

ReachableSpace::ReachableSpace(FloorGrid plan, const Eigen::Vector2d& start, double radius_m)
    : plan_(std::move(plan)), start_(start), radius_m_(radius_m) {
  update();
}

void ReachableSpace::update() {
  room_ = standing_room(plan_, radius_m_);
  labels_ = connected_areas(room_);
  start_label_ = 0;
  double nearest_m = kNearStart_m;
  for_cells_within(room_, start_, kNearStart_m, [&](Cell cell, double distance_m) {
    if (labels_[room_.index(cell)] == 0 || distance_m > nearest_m) return;
    nearest_m = distance_m;
    start_label_ = labels_[room_.index(cell)];
  });
}

bool ReachableSpace::can_start() const { return start_label_ != 0; }

bool ReachableSpace::comes_within(const Eigen::Vector2d& p, double distance_m) const {
  bool reached = false;
  for_cells_within(room_, p, distance_m, [&](Cell cell, double) {
    reached = reached || (start_label_ != 0 && labels_[room_.index(cell)] == start_label_);
  });
  return reached;
}

bool ReachableSpace::try_to_block(const Eigen::Vector2d& p, double radius_m, double reach_m) {
  ReachableSpace next = *this;
  // The cell of the middle is taken even by what is smaller than a cell.
  next.plan_.set(plan_.cell_at(p), Occupancy::kOccupied);
  for_cells_within(plan_, p, radius_m, [&](Cell cell, double) { next.plan_.set(cell, Occupancy::kOccupied); });
  next.blocked_.push_back({p, reach_m});
  next.update();
  if (!next.can_start()) return false;
  int cut_off = 0;  // places that were reachable, are free still, and cannot be reached any more
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (labels_[i] == start_label_ && next.labels_[i] != 0 && next.labels_[i] != next.start_label_) ++cut_off;
  }
  const double cell_m2 = plan_.resolution_m() * plan_.resolution_m();
  if (cut_off * cell_m2 > kPocket_m2) return false;
  for (const Blocked& object : next.blocked_) {
    if (!next.comes_within(object.p, object.reach_m)) return false;
  }
  *this = std::move(next);
  return true;
}

}  // namespace amiss::sim::internal
