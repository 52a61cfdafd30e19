#include "sim/free_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "core/result.hpp"
#include "sim/internal/tessellate.hpp"
#include "world/bounds.hpp"

namespace amiss::sim {
namespace {

using Polygon = std::vector<Eigen::Vector2d>;

constexpr int kMaxCells = 4000;  // along one side of a grid
constexpr double kPlanResolution_m = 0.05;

/// The part of a convex polygon in space on one side of a horizontal plane (Sutherland and Hodgman 1974).
std::vector<Eigen::Vector3d> clip(const std::vector<Eigen::Vector3d>& polygon, double z, bool keep_above) {
  std::vector<Eigen::Vector3d> out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const bool a_in = keep_above ? a.z() > z : a.z() < z, b_in = keep_above ? b.z() > z : b.z() < z;
    if (a_in) out.push_back(a);
    if (a_in != b_in) out.emplace_back(a + (z - a.z()) / (b.z() - a.z()) * (b - a));
  }
  return out;
}

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Convex hull, counter-clockwise (Andrew 1979).
Polygon hull_of(Polygon points) {
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); });
  Polygon hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const Eigen::Vector2d& p : points) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0.0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull.empty() ? points : hull;
}

/// Marks all cells that a convex polygon touches: a separating axis of cell and polygon is one of their edges' normals.
void fill(FloorGrid& grid, const Polygon& polygon) {
  if (polygon.empty()) return;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : polygon) box.extend(p);
  const Cell low = grid.cell_at(box.min()), high = grid.cell_at(box.max());
  const double half = 0.5 * grid.resolution_m();
  for (int y = std::max(0, low.y); y <= std::min(grid.height() - 1, high.y); ++y) {
    for (int x = std::max(0, low.x); x <= std::min(grid.width() - 1, high.x); ++x) {
      const Eigen::Vector2d middle = grid.centre_of({x, y});
      bool apart = false;
      for (std::size_t i = 0; i < polygon.size() && !apart; ++i) {
        const Eigen::Vector2d edge = polygon[(i + 1) % polygon.size()] - polygon[i];
        const Eigen::Vector2d normal(edge.y(), -edge.x());  // outwards
        apart = normal.dot(middle - polygon[i]) > half * normal.lpNorm<1>() + 1e-12;
      }
      if (!apart) grid.set({x, y}, Occupancy::kOccupied);
    }
  }
}

/// The outlines, on the floor, of what a shape has between two heights: one for a solid, one a triangle for a mesh.
std::vector<Polygon> footprints(const world::Shape& shape, const Eigen::Isometry3d& T, double low_m, double high_m) {
  std::vector<Polygon> out;
  Polygon all;
  for (const internal::Triangle& triangle : internal::tessellate(shape.geometry)) {
    const std::vector<Eigen::Vector3d> corners{T * triangle[0], T * triangle[1], T * triangle[2]};
    Polygon part;
    for (const Eigen::Vector3d& p : clip(clip(corners, low_m, true), high_m, false)) part.push_back(p.head<2>());
    if (part.empty()) continue;
    all.insert(all.end(), part.begin(), part.end());
    out.push_back(hull_of(std::move(part)));
  }
  if (internal::is_solid(shape.geometry) && !all.empty()) return {hull_of(std::move(all))};
  return out;
}

bool takes_part(const world::Body& body, bool with_moving) { return body.is_static || with_moving; }

/// Bounds of everything that stands up from the floor; of everything where nothing does.
Eigen::AlignedBox3d extent_of(const world::World& world) {
  Eigen::AlignedBox3d upright, all;
  for (const world::Body& body : world.bodies) {
    for (const world::Shape& shape : body.collisions) {
      const Eigen::AlignedBox3d box = world::bounds(shape.geometry, body.pose.T * shape.T_body_shape);
      if (box.isEmpty()) continue;
      all.extend(box);
      if (box.max().z() > 0.1 && !std::holds_alternative<world::Plane>(shape.geometry)) upright.extend(box);
    }
  }
  return upright.isEmpty() ? all : upright;
}

}  // namespace

FloorGrid floor_plan(const world::World& world, double resolution_m, double low_m, double high_m, bool with_moving) {
  const Eigen::AlignedBox3d extent = extent_of(world);
  if (extent.isEmpty()) return {};
  const Eigen::Vector2d origin = extent.min().head<2>().array() - resolution_m;
  const Eigen::Vector2d size = extent.sizes().head<2>().array() + 2.0 * resolution_m;
  if (size.maxCoeff() / resolution_m > kMaxCells) {
    throw InputError(world.file.string() + ": the world measures " + std::to_string(size.maxCoeff()) + " m; up to " +
                     std::to_string(kMaxCells * resolution_m) + " m are allowed");
  }
  FloorGrid grid(resolution_m, origin, static_cast<int>(std::ceil(size.x() / resolution_m)),
                 static_cast<int>(std::ceil(size.y() / resolution_m)), Occupancy::kFree);
  for (const world::Body& body : world.bodies) {
    if (!takes_part(body, with_moving)) continue;
    for (const world::Shape& shape : body.collisions) {
      for (const Polygon& polygon : footprints(shape, body.pose.T * shape.T_body_shape, low_m, high_m)) {
        fill(grid, polygon);
      }
    }
  }
  return grid;
}

std::vector<int> connected_areas(const FloorGrid& grid) {
  std::vector<int> labels(grid.cells().size(), 0);
  int last = 0;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (grid.at(Cell{x, y}) != Occupancy::kFree || labels[grid.index({x, y})] != 0) continue;
      labels[grid.index({x, y})] = ++last;
      std::deque<Cell> open{{x, y}};
      while (!open.empty()) {
        const Cell c = open.front();
        open.pop_front();
        for (int k = 0; k < 9; ++k) {
          const Cell n{c.x + k % 3 - 1, c.y + k / 3 - 1};
          if (grid.at(n) != Occupancy::kFree || labels[grid.index(n)] != 0) continue;
          labels[grid.index(n)] = last;
          open.push_back(n);
        }
      }
    }
  }
  return labels;
}

FloorGrid standing_room(const FloorGrid& plan, double radius_m) {
  const std::vector<float> clearance = distance_to_occupied_m(plan, false);
  FloorGrid room(plan.resolution_m(), plan.origin_m(), plan.width(), plan.height(), Occupancy::kOccupied);
  for (int y = 0; y < plan.height(); ++y) {
    for (int x = 0; x < plan.width(); ++x) {
      if (static_cast<double>(clearance[plan.index({x, y})]) >= radius_m) room.set({x, y}, Occupancy::kFree);
    }
  }
  return room;
}

namespace {

struct Area {
  int cells = 0;
  bool is_open = false;  // reaches the edge of the world
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
};

/// The largest area that does not reach the edge of the world, or the largest of all.
int main_area(const FloorGrid& room, const std::vector<int>& labels, std::vector<Area>& areas) {
  areas.resize(static_cast<std::size_t>(labels.empty() ? 0 : *std::max_element(labels.begin(), labels.end())) + 1);
  for (int y = 0; y < room.height(); ++y) {
    for (int x = 0; x < room.width(); ++x) {
      Area& area = areas[static_cast<std::size_t>(labels[room.index({x, y})])];
      ++area.cells;
      area.sum += room.centre_of({x, y});
      area.is_open |= x == 0 || y == 0 || x == room.width() - 1 || y == room.height() - 1;
    }
  }
  std::size_t best = 0;
  for (std::size_t i = 1; i < areas.size(); ++i) {
    const auto rank = [&](std::size_t k) { return std::pair(!areas[k].is_open, areas[k].cells); };
    if (best == 0 || rank(i) > rank(best)) best = i;
  }
  return static_cast<int>(best);
}

}  // namespace

Pose2<amiss::World, Base> free_start(const world::World& world, const robot::Model& model) {
  const FloorGrid plan = floor_plan(world, kPlanResolution_m, kLowestObstacle_m, model.height_m, true);
  const FloorGrid room = standing_room(plan, model.navigation_radius_m);
  const std::vector<float> clearance = distance_to_occupied_m(plan, false);
  const std::vector<int> labels = connected_areas(room);
  std::vector<Area> areas;
  const int best_area = main_area(room, labels, areas);
  if (best_area == 0) {
    throw InputError(world.file.string() + ": no free place for the robot to start at; a disc of " +
                     std::to_string(model.navigation_radius_m) + " m radius must fit somewhere on the floor");
  }
  const Area& area = areas[static_cast<std::size_t>(best_area)];
  const Eigen::Vector2d middle = area.sum / area.cells;
  Eigen::Vector2d best = middle;
  double best_score = -1e9;
  for (int y = 0; y < room.height(); ++y) {
    for (int x = 0; x < room.width(); ++x) {
      if (labels[room.index({x, y})] != best_area) continue;
      // More than a metre of air is no better; a metre farther from the middle costs 5 cm of it.
      const Eigen::Vector2d p = room.centre_of({x, y});
      const double air_m = std::min(1.0, static_cast<double>(clearance[room.index({x, y})]));
      const double score = air_m - 0.05 * (p - middle).norm();
      if (score <= best_score) continue;
      best_score = score;
      best = p;
    }
  }
  return {best.x(), best.y(), 0.0};
}

}  // namespace amiss::sim
