// What the robot may drive over: several layers merged into one grid, and how far each cell is from what is occupied.
// FloorGrids of the map frame (reference laser grid, obstacle layers) and laser hits now -> grid and clearance field.
// Clearance [m]: from a cell's centre to the edge of the nearest occupied cell, at most `clearance_cap_m`.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/floor_grid.hpp"
#include "core/params.hpp"
#include "core/sensors.hpp"

namespace amiss::motion {

struct DriveParams {
  double robot_radius_m = 0.30;  // clearance that a path keeps
  double preferred_clearance_m = 0.45;
  double clearance_cap_m = 1.0;
  bool unknown_is_occupied = false;  // unknown cells are never driven over; true: they also keep their distance
};
void describe(ParamTable& table, DriveParams& params);

struct CellBox {
  Cell low, high;  // both belong to it; empty where high < low
  [[nodiscard]] int width() const { return high.x - low.x + 1; }
  [[nodiscard]] int height() const { return high.y - low.y + 1; }
};

class DriveMap {
 public:
  /// The grid has the geometry of `reference`, which is merged into every update.
  DriveMap(FloorGrid reference, DriveParams params);

  /// Replaces the reference by one of any size (mapping run) and forgets the other layers. What lies more than 1 m
  /// outside of the box round its known cells is left out, so a large unknown border costs nothing.
  void reset(FloorGrid reference);
  /// Reference + occupied cells of the layers (any geometry) + hits; what is no longer there is cleared. Cells free in
  /// a layer and unknown in the reference become free. A hit beside an occupied cell is that cell, seen with noise.
  /// Only the part that changed is computed anew.
  /// Returns the number of cells that changed.
  std::size_t update(std::span<const FloorGrid* const> layers, std::span<const Eigen::Vector2d> hits_map);
  /// Cells within `radius_m` are free whatever the layers say, from the next update on (the robot stands there).
  void keep_free(std::vector<Eigen::Vector2d> places_map, double radius_m);

  [[nodiscard]] const FloorGrid& grid() const { return grid_; }
  [[nodiscard]] const DriveParams& params() const { return params_; }
  [[nodiscard]] const CellBox& box() const { return box_; }  // no cell outside of it is passable
  [[nodiscard]] std::span<const float> clearance_m() const { return clearance_m_; }
  [[nodiscard]] float clearance_at(Cell c) const { return grid_.contains(c) ? clearance_m_[grid_.index(c)] : 0.0F; }
  /// Bilinear between cell centres; 0 outside.
  [[nodiscard]] double clearance_at(const Eigen::Vector2d& p_map) const;
  /// Can the robot's centre be in this cell: known free, with clearance of at least the robot's radius?
  [[nodiscard]] bool passable(Cell c) const {
    return grid_.at(c) == Occupancy::kFree && clearance_m_[grid_.index(c)] >= passable_from_m_;
  }
  /// The passable cell nearest to a place, if there is one within `radius_m`.
  [[nodiscard]] std::optional<Cell> nearest_passable(const Eigen::Vector2d& p_map, double radius_m) const;

 private:
  void recompute(const CellBox& changed);
  void add_hits(std::span<const Eigen::Vector2d> hits_map);

  DriveParams params_;
  float passable_from_m_ = 0.0F;
  CellBox box_;
  FloorGrid reference_, grid_, scratch_;
  std::vector<float> clearance_m_;
  std::vector<Eigen::Vector2d> free_places_;
  double free_radius_m_ = 0.0;
};

/// Where the beams of a sweep ended, in the base frame; beams without return and beyond `max_range_m` are left out.
[[nodiscard]] std::vector<Eigen::Vector2d> laser_hits(const LaserScan& scan, const Transform<Base, Laser>& T_base_laser,
                                                      double max_range_m);
/// The same in the map frame.
[[nodiscard]] std::vector<Eigen::Vector2d> laser_hits(const LaserScan& scan, const Pose2<Map, Base>& T_map_base,
                                                      const Transform<Base, Laser>& T_base_laser, double max_range_m);

}  // namespace amiss::motion
