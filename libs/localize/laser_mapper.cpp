#include "localize/laser_mapper.hpp"

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/slam/CICP.h>

#include <algorithm>
#include <queue>

#include "localize/internal/grid_drawing.hpp"
#include "localize/internal/line_map.hpp"
#include "localize/internal/mrpt_types.hpp"

namespace amiss::localize {

namespace {

constexpr int kMatchedBeams = 240;        // of a scan, for MRPT's ICP and its point map
constexpr double kMatchDistanceM = 0.03;  // driven between two alignments; odometry alone in between
constexpr double kMatchAngleRad = radians(2.0);
constexpr std::size_t kMinPoints = 60;  // on surfaces, of a scan that is believed
constexpr double kFootprintM = 0.20;    // half the edge of the square that a robot surely covers
constexpr double kNewPart = 0.05;       // of a scan that is worth a place in the maps that are matched against

mrpt::slam::CICP::TConfigParams icp_options() {
  mrpt::slam::CICP::TConfigParams icp;
  icp.ICP_algorithm = mrpt::slam::icpClassic;
  icp.maxIterations = 30;
  icp.thresholdDist = 0.25;
  icp.thresholdAng = radians(2.0);
  icp.smallestThresholdDist = 0.05;
  icp.minAbsStep_trans = 1e-3;
  icp.minAbsStep_rot = 1e-4;
  icp.corresponding_points_decimation = 2;
  icp.skip_cov_calculation = true;
  icp.skip_quality_calculation = true;
  return icp;
}

}  // namespace

struct LaserMapper::State {
  explicit State(const LaserMapperParams& p) : params(p), icp(icp_options()), drawn(p.resolution_m, p.max_range_m) {
    points.insertionOptions.minDistBetweenLaserPoints = static_cast<float>(p.point_distance_m);
  }

  LaserMapperParams params;
  mrpt::slam::CICP icp;
  mrpt::maps::CSimplePointsMap points;
  internal::LineMap lines;
  internal::DrawnGrid drawn;
  bool started = false;
  Pose2<Odom, Base> T_odom_base_matched;  // of the last alignment
  Pose2<Map, Base> T_map_base_drawn;      // of the last scan in the grid
  Pose2<Map, Odom> T_map_odom;
  PoseEstimate estimate;

  [[nodiscard]] Pose2<Map, Base> matched(const mrpt::obs::CObservation2DRangeScan& scan,
                                         const Pose2<Map, Base>& predicted);
  void locate(const Odometry& odometry, const LaserScan& scan, const Transform<Base, Laser>& T_base_laser);
  void draw(const LaserScan& scan, const Transform<Base, Laser>& T_base_laser);
};

/// Point-to-point ICP on the point map: from where odometry predicts to the neighbourhood of the truth.
Pose2<Map, Base> LaserMapper::State::matched(const mrpt::obs::CObservation2DRangeScan& scan,
                                             const Pose2<Map, Base>& predicted) {
  if (points.empty()) return predicted;
  mrpt::maps::CSimplePointsMap sensed;
  sensed.insertionOptions.minDistBetweenLaserPoints = static_cast<float>(params.point_distance_m);
  sensed.insertObservation(scan);
  mrpt::slam::CICP::TReturnInfo info;
  const auto found = icp.Align(&points, &sensed, internal::to_mrpt(predicted), info);
  if (info.goodness < params.min_goodness) return predicted;
  return internal::pose_from_mrpt<Map, Base>(found->getMeanVal());
}

/// Only scans that show something new go into the maps that are matched against, so that a place seen again corrects
/// the pose instead of smearing the map.
void LaserMapper::State::locate(const Odometry& odometry, const LaserScan& scan,
                                const Transform<Base, Laser>& T_base_laser) {
  const auto observed = internal::to_mrpt(scan, T_base_laser, kMatchedBeams);
  const auto points_base = internal::line_points_of(scan, T_base_laser);
  const Pose2<Map, Base> guess = matched(*observed, T_map_odom * odometry.T_odom_base);
  const internal::LineAlignment found = lines.aligned(points_base, guess);
  const bool believed = !started || (found.matched_part >= params.min_goodness && points_base.size() >= kMinPoints);
  estimate.T_map_base = believed ? found.T_map_base : guess;
  estimate.covariance = found.covariance;
  estimate.converged = believed;
  T_odom_base_matched = odometry.T_odom_base;
  if (!believed || lines.new_part(points_base, estimate.T_map_base, params.point_distance_m) < kNewPart) return;
  lines.add(points_base, estimate.T_map_base, params.point_distance_m);
  const mrpt::poses::CPose3D pose(internal::to_mrpt(estimate.T_map_base));
  points.insertObservation(*observed, pose);
}

/// Draws key scans, also of places seen before: they sharpen the grid.
void LaserMapper::State::draw(const LaserScan& scan, const Transform<Base, Laser>& T_base_laser) {
  const Pose2<Base, Base> since = T_map_base_drawn.inverse() * estimate.T_map_base;
  const bool key = since.position().norm() >= params.key_distance_m || std::abs(since.yaw_rad) >= params.key_angle_rad;
  if (started && !(key && estimate.converged)) return;
  T_map_base_drawn = estimate.T_map_base;
  drawn.add(scan, T_base_laser, estimate.T_map_base);
}

LaserMapper::LaserMapper(const LaserMapperParams& params) : state_(std::make_unique<State>(params)) {}
LaserMapper::~LaserMapper() = default;
LaserMapper::LaserMapper(LaserMapper&&) noexcept = default;
LaserMapper& LaserMapper::operator=(LaserMapper&&) noexcept = default;

PoseEstimate LaserMapper::update(const Odometry& odometry, const LaserScan& scan,
                                 const Transform<Base, Laser>& T_base_laser) {
  State& s = *state_;
  if (!s.started) s.T_map_odom = Pose2<Map, Base>{} * odometry.T_odom_base.inverse();
  s.estimate.stamp = odometry.stamp;
  s.estimate.T_map_base = s.T_map_odom * odometry.T_odom_base;
  const bool seen_anything =
      std::any_of(scan.ranges_m.begin(), scan.ranges_m.end(), [](float range_m) { return std::isfinite(range_m); });
  const Pose2<Base, Base> since = s.T_odom_base_matched.inverse() * odometry.T_odom_base;
  const bool far = since.position().norm() >= kMatchDistanceM || std::abs(since.yaw_rad) >= kMatchAngleRad;
  if (!seen_anything) s.estimate.converged = false;
  if (!seen_anything || (s.started && !far)) return s.estimate;
  s.locate(odometry, scan, T_base_laser);
  s.T_map_odom = s.estimate.T_map_base * odometry.T_odom_base.inverse();
  s.draw(scan, T_base_laser);
  s.started = true;
  return s.estimate;
}

const PoseEstimate& LaserMapper::estimate() const { return state_->estimate; }
Pose2<Map, Odom> LaserMapper::T_map_odom() const { return state_->T_map_odom; }
const FloorGrid& LaserMapper::grid() { return state_->drawn.floor(); }
FloorGrid LaserMapper::cleaned_grid() { return cleaned(grid(), Eigen::Vector2d::Zero()); }

namespace {

bool has_neighbour(const FloorGrid& grid, Cell c, Occupancy value) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if ((dx != 0 || dy != 0) && grid.at(Cell{c.x + dx, c.y + dy}) == value) return true;
    }
  }
  return false;
}

/// Free cells in the footprint of a robot: not only the one under its middle, which its laser may never have crossed.
std::queue<Cell> free_cells_under(const FloorGrid& grid, const Eigen::Vector2d& robot_map) {
  std::queue<Cell> cells;
  const Cell low = grid.cell_at(robot_map - Eigen::Vector2d::Constant(kFootprintM));
  const Cell high = grid.cell_at(robot_map + Eigen::Vector2d::Constant(kFootprintM));
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      if (grid.contains({x, y}) && grid.at(Cell{x, y}) == Occupancy::kFree) cells.push({x, y});
    }
  }
  return cells;
}

/// Free cells that are reached through free cells, four neighbours each.
std::vector<bool> reached_from(const FloorGrid& grid, const Eigen::Vector2d& robot_map) {
  std::vector<bool> reached(grid.cells().size(), false);
  std::queue<Cell> open = free_cells_under(grid, robot_map);
  for (std::queue<Cell> starts = open; !starts.empty(); starts.pop()) reached[grid.index(starts.front())] = true;
  while (!open.empty()) {
    const Cell c = open.front();
    open.pop();
    for (const Cell next : {Cell{c.x + 1, c.y}, Cell{c.x - 1, c.y}, Cell{c.x, c.y + 1}, Cell{c.x, c.y - 1}}) {
      if (!grid.contains(next) || reached[grid.index(next)] || grid.at(next) != Occupancy::kFree) continue;
      reached[grid.index(next)] = true;
      open.push(next);
    }
  }
  return reached;
}

}  // namespace

FloorGrid cleaned(const FloorGrid& grid, const Eigen::Vector2d& reachable_from_map) {
  FloorGrid out = grid;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const Cell c{x, y};
      if (grid.at(c) != Occupancy::kOccupied) continue;
      const bool alone = !has_neighbour(grid, c, Occupancy::kOccupied) && !has_neighbour(grid, c, Occupancy::kUnknown);
      if (alone) out.set(c, Occupancy::kFree);
    }
  }
  const std::vector<bool> reached = reached_from(out, reachable_from_map);
  for (int y = 0; y < out.height(); ++y) {
    for (int x = 0; x < out.width(); ++x) {
      const Cell c{x, y};
      if (out.at(c) == Occupancy::kFree && !reached[out.index(c)]) out.set(c, Occupancy::kUnknown);
    }
  }
  return out;
}

}  // namespace amiss::localize
