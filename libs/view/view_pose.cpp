#include "view/view_pose.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace amiss::view {
namespace {

constexpr int kSides = 12;
constexpr double kOwn_m = 0.10;  // round the region: what blocks there is the region itself
constexpr double kAngleStep_rad = radians(10);
constexpr double kRadiusStep_m = 0.10;
constexpr double kOccludedCost_m = 1.0;  // of a view that sees nothing of the region

/// Is the cylinder with its margin inside the image and not too near?
bool fits(const Cylinder& region, const Head& head, const Transform<Camera, Map>& T_camera_map,
          const PoseParams& params) {
  // The corners of a prism round the cylinder.
  const double radius_m = (region.radius_m + params.margin_m) / std::cos(std::numbers::pi / kSides);
  const double half_m = 0.5 * region.height_m;
  const double low_m = std::max(std::min(0.0, region.middle_m.z()), region.middle_m.z() - half_m - params.margin_m);
  const double high_m = region.middle_m.z() + half_m + params.margin_m;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * i * std::numbers::pi / kSides;
    for (const double z : {low_m, high_m}) {
      const Eigen::Vector3d p = T_camera_map.T * Eigen::Vector3d(region.middle_m.x() + radius_m * std::cos(angle),
                                                                 region.middle_m.y() + radius_m * std::sin(angle), z);
      if (p.z() < params.min_depth_m) return false;
      const double u = head.camera.fx * p.x() / p.z() + head.camera.cx;
      const double v = head.camera.fy * p.y() / p.z() + head.camera.cy;
      if (u < 0.0 || v < 0.0 || u > head.camera.width - 1 || v > head.camera.height - 1) return false;
    }
  }
  return true;
}

/// Share of the rays from the camera to the region that nothing outside of it blocks.
double clear_share(const Cylinder& region, const Eigen::Vector3d& eye, const SightTest& clear) {
  const Eigen::Vector2d to = region.middle_m.head<2>() - eye.head<2>();
  const Eigen::Vector2d ahead = to.normalized();
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  const double side_m = 0.8 * region.radius_m, half_m = 0.5 * region.height_m;
  struct Aim {
    double aside_m, up_m;
  };
  const std::array<Aim, 5> aims{{{0.0, 0.0}, {0.0, 0.8 * half_m}, {0.0, -0.5 * half_m}, {side_m, 0.0}, {-side_m, 0.0}}};
  const double before_m = std::max(0.0, to.norm() - region.radius_m - kOwn_m);  // where the region's own space begins
  int free = 0;
  for (const Aim& aim : aims) {
    Eigen::Vector3d target = region.middle_m + Eigen::Vector3d(0.0, 0.0, aim.up_m);
    target.head<2>() += aim.aside_m * left;
    free += clear(eye, eye + before_m / to.norm() * (target - eye)) ? 1 : 0;
  }
  return static_cast<double>(free) / static_cast<double>(aims.size());
}

/// A place beside an ideal one, in polar coordinates round the region.
struct Shift {
  double angle_rad, radius_m, deviation_m;
};

std::vector<Shift> shifts(const Cylinder& region, const PoseParams& params) {
  const double ideal_m = region.radius_m + params.preferred_dist_m;
  std::vector<Shift> all;
  const int turns = static_cast<int>(std::floor(0.5 * params.exam_step_rad / kAngleStep_rad + 1e-9));
  const int least = static_cast<int>(std::ceil((params.exam_dist_m - params.preferred_dist_m) / kRadiusStep_m - 1e-9));
  const int most = static_cast<int>(std::floor((params.max_dist_m - params.preferred_dist_m) / kRadiusStep_m + 1e-9));
  for (int radius = least; radius <= most; ++radius) {
    for (int turn = -turns; turn <= turns; ++turn) {
      const double shift_m = radius * kRadiusStep_m, angle_rad = turn * kAngleStep_rad;
      all.push_back({angle_rad, ideal_m + shift_m, std::abs(shift_m) + std::abs(angle_rad) * ideal_m});
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Shift& a, const Shift& b) { return a.deviation_m < b.deviation_m; });
  return all;
}

class Examiner {
 public:
  Examiner(const Cylinder& region, const FloorGrid& grid, std::span<const float> travel_m, const SightTest& clear,
           const Head& head, const PoseParams& params)
      : region_(region), grid_(grid), travel_m_(travel_m), clear_(clear), head_(head), params_(params) {}

  [[nodiscard]] std::optional<ViewPose> view_from(double angle_rad, const Shift& shift) const {
    const double angle = angle_rad + shift.angle_rad;
    const Eigen::Vector2d place =
        region_.middle_m.head<2>() + shift.radius_m * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const Cell cell = grid_.cell_at(place);
    if (!grid_.contains(cell) || !std::isfinite(travel_m_[grid_.index(cell)])) return std::nullopt;

    ViewPose view;
    view.T_map_base = {place.x(), place.y(), wrap_angle(angle + std::numbers::pi)};
    const robot::HeadState state = look_at(head_, view.T_map_base, region_.middle_m);
    const Transform<Map, Camera> T_map_camera = view.T_map_base.lift() * head_.T_base_camera(state);
    if (!fits(region_, head_, T_map_camera.inverse(), params_)) return std::nullopt;
    view.clear_share = clear_share(region_, T_map_camera.position(), clear_);
    if (view.clear_share < params_.min_clear_share) return std::nullopt;
    view.pan_rad = state.pan_rad;
    view.tilt_rad = state.tilt_rad;
    view.distance_m = (region_.middle_m - T_map_camera.position()).norm();
    view.travel_m = static_cast<double>(travel_m_[grid_.index(cell)]);
    view.cost = shift.deviation_m + params_.travel_weight * view.travel_m + kOccludedCost_m * (1.0 - view.clear_share);
    return view;
  }

 private:
  const Cylinder& region_;
  const FloorGrid& grid_;
  std::span<const float> travel_m_;
  const SightTest& clear_;
  const Head& head_;
  const PoseParams& params_;
};

}  // namespace

void describe(ParamTable& table, PoseParams& p) {
  table.number("exam.dist", p.exam_dist_m, "m", 0.05, 5.0, "robot centre to object boundary, at least (exam_dist)");
  table.number("exam.preferred_dist", p.preferred_dist_m, "m", 0.05, 5.0, "robot centre to object boundary, ideal");
  table.number("exam.max_dist", p.max_dist_m, "m", 0.05, 10.0, "robot centre to object boundary, at most");
  table.number("exam.step", p.exam_step_rad, "deg", 5.0, 180.0, "between the ideal viewpoints (exam_step)");
  table.number("exam.margin", p.margin_m, "m", 0.0, 2.0, "round the region, inside the image");
  table.number("exam.min_depth", p.min_depth_m, "m", 0.0, 5.0, "nothing of the region may be nearer to the camera");
  table.number("exam.travel_weight", p.travel_weight, "", 0.0, 10.0, "cost of a metre of way, in metres of deviation");
  table.number("exam.min_clear", p.min_clear_share, "", 0.0, 1.0, "share of the rays to the region that must be free");
}

std::vector<ViewPose> view_poses(const Cylinder& region, const FloorGrid& grid, std::span<const float> travel_m,
                                 const SightTest& clear, const Head& head, const PoseParams& params) {
  assert(travel_m.size() == grid.cells().size());
  const Examiner examiner(region, grid, travel_m, clear, head, params);
  const std::vector<Shift> near = shifts(region, params);
  const int directions = std::max(1, static_cast<int>(std::lround(2.0 * std::numbers::pi / params.exam_step_rad)));
  std::vector<ViewPose> views;
  for (int i = 0; i < directions; ++i) {
    for (const Shift& shift : near) {
      const auto view = examiner.view_from(i * 2.0 * std::numbers::pi / directions, shift);
      if (!view) continue;
      views.push_back(*view);
      break;
    }
  }
  std::stable_sort(views.begin(), views.end(), [](const ViewPose& a, const ViewPose& b) { return a.cost < b.cost; });
  return views;
}

}  // namespace amiss::view
