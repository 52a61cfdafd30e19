#include "localize/internal/global_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace amiss::localize::internal {

namespace {

constexpr double kLatticeM = 0.15;    // between two places
constexpr int kYaws = 60;             // of one place
constexpr std::size_t kPoints = 60;   // about, of a scan
constexpr double kClearanceM = 0.2;   // of a robot's middle from any wall
constexpr float kWideM = 0.4F;        // a point farther from any wall is as bad as this
constexpr std::size_t kKept = 3000;   // poses of the lattice that are looked at again
constexpr std::size_t kAligned = 24;  // and of these, apart from each other
constexpr double kApartM = 0.3;
constexpr double kApartRad = radians(15.0);
constexpr double kFreeM = 1.0, kFreeRad = 0.5;  // deviations of a prior that has next to no say

struct Coarse {
  std::uint32_t place = 0;
  std::uint16_t yaw = 0;
  float cost = 0.0F;
};

double yaw_of(int i) { return 2.0 * std::numbers::pi * i / kYaws; }

std::vector<Eigen::Vector2d> thinned(const std::vector<Eigen::Vector2d>& points) {
  const std::size_t stride = std::max<std::size_t>(1, points.size() / kPoints);
  std::vector<Eigen::Vector2d> few;
  for (std::size_t i = 0; i < points.size(); i += stride) few.push_back(points[i]);
  return few;
}

/// Distances, limited, of the cells that the points fall into when the robot stands in the middle of a cell.
float coarse_cost(const DistanceField& field, const std::vector<Cell>& points, const Cell& place) {
  const FloorGrid& frame = field.map();
  float sum = 0.0F;
  for (const Cell& p : points) {
    const Cell c{place.x + p.x, place.y + p.y};
    sum += frame.contains(c) ? std::min(kWideM, field.cell_distances_m()[frame.index(c)]) : kWideM;
  }
  return sum;
}

std::vector<Coarse> lattice(const DistanceField& field, const std::vector<Eigen::Vector2d>& places,
                            const std::vector<Eigen::Vector2d>& points_base) {
  const double resolution_m = field.map().resolution_m();
  std::vector<Cell> cells;
  for (const Eigen::Vector2d& place : places) cells.push_back(field.map().cell_at(place));
  std::vector<Coarse> all;
  all.reserve(places.size() * kYaws);
  for (int yaw = 0; yaw < kYaws; ++yaw) {
    const Eigen::Matrix2d R = Eigen::Rotation2Dd(yaw_of(yaw)).toRotationMatrix();
    std::vector<Cell> turned;
    for (const Eigen::Vector2d& p : points_base) {
      const Eigen::Vector2d steps = R * p / resolution_m;
      turned.push_back({static_cast<int>(std::lround(steps.x())), static_cast<int>(std::lround(steps.y()))});
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      all.push_back(
          {static_cast<std::uint32_t>(i), static_cast<std::uint16_t>(yaw), coarse_cost(field, turned, cells[i])});
    }
  }
  const auto better = [](const Coarse& a, const Coarse& b) {
    return std::tie(a.cost, a.place, a.yaw) < std::tie(b.cost, b.place, b.yaw);
  };
  const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(kKept, all.size()));
  std::partial_sort(all.begin(), end, all.end(), better);
  all.erase(end, all.end());
  return all;
}

bool is_apart(const Pose2<Map, Base>& pose, const std::vector<Pose2<Map, Base>>& others) {
  return std::none_of(others.begin(), others.end(), [&](const auto& other) { return is_same_place(pose, other); });
}

}  // namespace

std::vector<Eigen::Vector2d> places_to_stand(const FloorGrid& map, const DistanceField& field) {
  const int step = std::max(1, static_cast<int>(std::lround(kLatticeM / map.resolution_m())));
  std::vector<Eigen::Vector2d> places;
  for (int y = 0; y < map.height(); y += step) {
    for (int x = 0; x < map.width(); x += step) {
      const Eigen::Vector2d centre = map.centre_of({x, y});
      if (map.at(Cell{x, y}) == Occupancy::kFree && field.at(centre).distance_m >= kClearanceM)
        places.push_back(centre);
    }
  }
  return places;
}

bool is_same_place(const Pose2<Map, Base>& a, const Pose2<Map, Base>& b) {
  return (a.position() - b.position()).norm() < kApartM && std::abs(wrap_angle(a.yaw_rad - b.yaw_rad)) < kApartRad;
}

std::vector<FittingPose> best_on_map(const DistanceField& field, const std::vector<Eigen::Vector2d>& places_map,
                                     const std::vector<Eigen::Vector2d>& points_base, const Eigen::Vector2d& laser_base,
                                     double near_m) {
  if (points_base.empty()) return {};
  std::vector<Pose2<Map, Base>> starts;
  for (const Coarse& c : lattice(field, places_map, thinned(points_base))) {
    const Eigen::Vector2d& place = places_map[c.place];
    const Pose2<Map, Base> pose{place.x(), place.y(), wrap_angle(yaw_of(c.yaw))};
    if (is_apart(pose, starts)) starts.push_back(pose);
    if (starts.size() == kAligned) break;
  }
  std::vector<FittingPose> found;
  for (const Pose2<Map, Base>& start : starts) {
    const Pose2<Map, Base> pose = aligned(field, points_base, {start, kFreeM, kFreeRad});
    found.push_back({pose, fit_of(field, points_base, pose, near_m),
                     plausibility_of(field, points_base, laser_base, pose, near_m)});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.plausibility > b.plausibility; });
  std::vector<FittingPose> apart;
  for (const FittingPose& f : found) {
    const bool is_new = std::none_of(apart.begin(), apart.end(), [&](const FittingPose& other) {
      return is_same_place(f.T_map_base, other.T_map_base);
    });
    if (is_new) apart.push_back(f);
  }
  return apart;
}

}  // namespace amiss::localize::internal
