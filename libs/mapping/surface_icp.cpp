#include "mapping/surface_icp.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/result.hpp"
#include "mapping/internal/frame_check.hpp"

namespace amiss::mapping {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;  // rotation, translation
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kPointSigmaM = 0.005;                       // of one depth pixel against the model
constexpr double kIndependentPoints = 300.0;                 // neighbours err alike: no frame counts for more
constexpr double kNoDoubt = 1e-9;                            // standard deviation of what is not refined
constexpr double kLeastGradient = 0.3, kMostGradient = 3.0;  // of a distance field that is one
constexpr double kStill = 1e-5;                              // a step of so little ends the search [m, rad]

void check(const RefinementParams& p) {
  const auto require = [](bool good, const char* sentence) {
    if (!good) throw ArgumentError(sentence);
  };
  require(p.pixel_step >= 1, "refine.pixel_step must be 1 or more");
  require(p.iterations >= 1, "refine.iterations must be 1 or more");
  require(p.expected_shift_m > 0.0 && p.expected_turn_rad > 0.0,
          "refine.expected_shift and refine.expected_turn must be positive");
  require(p.max_shift_m > 0.0 && p.max_turn_rad > 0.0, "refine.max_shift and refine.max_turn must be positive");
  require(p.min_overlap >= 0.0 && p.min_overlap <= 1.0, "refine.min_overlap: allowed are 0 to 1");
  require(p.max_rms_voxels > 0.0, "refine.max_rms must be positive");
}

std::vector<Eigen::Vector3d> points_of(const RgbdFrame& frame, const SurfaceParams& surface, int step) {
  std::vector<Eigen::Vector3d> points;
  const CameraIntrinsics& k = frame.intrinsics;
  for (int v = step / 2; v < k.height; v += step) {
    for (int u = step / 2; u < k.width; u += step) {
      const std::size_t pixel =
          static_cast<std::size_t>(v) * static_cast<std::size_t>(k.width) + static_cast<std::size_t>(u);
      const auto z = static_cast<double>(frame.depth_m[pixel]);
      const Eigen::Vector3d p((u - k.cx) / k.fx * z, (v - k.cy) / k.fy * z, z);
      if (std::isfinite(z) && z >= surface.min_range_m && p.norm() <= surface.max_range_m) points.push_back(p);
    }
  }
  return points;
}

/// Rotation vector and shift of the camera that lead from one pose to the other, both in the map frame.
Vector6 between(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  const Eigen::AngleAxisd turn(to.linear() * from.linear().transpose());
  Vector6 way;
  way << turn.angle() * turn.axis(), to.translation() - from.translation();
  return way;
}

/// Turned about the camera, then shifted.
Eigen::Isometry3d moved(const Eigen::Isometry3d& T, const Vector6& step) {
  Eigen::Isometry3d result = T;
  const Eigen::Vector3d turn = step.head<3>();
  if (turn.norm() > 0.0) {
    result.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * T.linear();
  }
  result.translation() += step.tail<3>();
  return result;
}

struct Fit {
  Matrix6 H = Matrix6::Zero();
  Vector6 b = Vector6::Zero();
  std::size_t pairs = 0;
  double squares = 0.0;

  [[nodiscard]] double rms() const { return pairs == 0 ? 0.0 : std::sqrt(squares / static_cast<double>(pairs)); }
};

Fit fit_at(const SurfaceMap& map, const std::vector<Eigen::Vector3d>& points, const Eigen::Isometry3d& T) {
  Fit fit;
  const double edge = map.params().voxel_m;  // beyond it Huber's weight falls
  for (const Eigen::Vector3d& p_camera : points) {
    const Eigen::Vector3d p = T * p_camera;
    const auto sample = map.sample(p);
    if (!sample) continue;
    const double slope = static_cast<double>(sample->gradient.norm());
    if (slope < kLeastGradient || slope > kMostGradient) continue;
    const Eigen::Vector3d n = sample->gradient.cast<double>() / slope;
    const double distance = static_cast<double>(sample->distance_m) / slope;
    const double weight = std::abs(distance) <= edge ? 1.0 : edge / std::abs(distance);
    Vector6 J;
    J << (p - T.translation()).cross(n), n;
    fit.H += weight * J * J.transpose();
    fit.b += weight * distance * J;
    fit.squares += weight * distance * distance;
    ++fit.pairs;
  }
  return fit;
}

/// Information of the expected pose.
Vector6 information(const RefinementParams& p) {
  Vector6 sigma;
  const double tilt = p.planar ? kNoDoubt : p.expected_turn_rad, up = p.planar ? kNoDoubt : p.expected_shift_m;
  sigma << tilt, tilt, p.expected_turn_rad, p.expected_shift_m, p.expected_shift_m, up;
  return sigma.cwiseAbs2().cwiseInverse();
}

std::string reason_against(const Refinement& r, const RefinementParams& p, double voxel_m) {
  if (r.overlap() < p.min_overlap) return "too little of the frame lies on the model";
  if (r.shift_m > p.max_shift_m || r.turn_rad > p.max_turn_rad) return "further from the expected pose than allowed";
  if (r.rms_after_m > p.max_rms_voxels * voxel_m) return "the frame does not fit the model";
  if (r.rms_after_m > r.rms_before_m) return "no better than the expected pose";
  return "";
}

}  // namespace

void describe(ParamTable& table, RefinementParams& p) {
  table.flag("refine.planar", p.planar, "only x, y and heading are refined, as of a robot on a floor");
  table.integer("refine.pixel_step", p.pixel_step, 1, 32, "every so many rows and columns give a point");
  table.integer("refine.iterations", p.iterations, 1, 100, "of Gauss-Newton at most");
  table.number("refine.expected_shift", p.expected_shift_m, "m", 1e-4, 1,
               "standard deviation of the expected position");
  table.number("refine.expected_turn", p.expected_turn_rad, "deg", 0.01, 45,
               "standard deviation of the expected direction");
  table.number("refine.max_shift", p.max_shift_m, "m", 0.001, 1, "corrections beyond it are refused");
  table.number("refine.max_turn", p.max_turn_rad, "deg", 0.1, 45, "corrections beyond it are refused");
  table.number("refine.min_overlap", p.min_overlap, "", 0, 1, "share of the frame's points that must lie on the model");
  table.number("refine.max_rms", p.max_rms_voxels, "voxels", 0.1, 10, "distance to the model that still fits");
}

Refinement refine_pose(const SurfaceMap& map, const RgbdFrame& frame, const Transform<Map, Camera>& expected,
                       const Transform<Map, Camera>& start, const RefinementParams& params) {
  check(params);
  check_frame(frame, expected, map.params().voxel_m);
  check_frame(frame, start, map.params().voxel_m);
  const std::vector<Eigen::Vector3d> points = points_of(frame, map.params(), params.pixel_step);
  const Vector6 prior = information(params);
  Refinement result;
  result.points = points.size();
  result.rms_before_m = fit_at(map, points, expected.T).rms();

  Eigen::Isometry3d T = start.T;
  Fit fit = fit_at(map, points, T);
  for (; result.iterations < params.iterations; ++result.iterations) {
    if (fit.pairs == 0) break;
    const double independent = std::min(1.0, kIndependentPoints / static_cast<double>(fit.pairs));
    const double information = independent / (kPointSigmaM * kPointSigmaM);
    const Matrix6 H = information * fit.H + Matrix6(prior.asDiagonal());
    const Vector6 b = information * fit.b + prior.cwiseProduct(between(expected.T, T));
    const Vector6 step = H.ldlt().solve(-b);
    if (!step.allFinite()) break;
    T = moved(T, step);
    fit = fit_at(map, points, T);
    if (step.cwiseAbs().maxCoeff() < kStill) break;
  }

  const Vector6 way = between(expected.T, T);
  result.pairs = fit.pairs;
  result.rms_after_m = fit.rms();
  result.turn_rad = way.head<3>().norm();
  result.shift_m = way.tail<3>().norm();
  result.why = reason_against(result, params, map.params().voxel_m);
  result.accepted = result.why.empty();
  result.T_map_camera = result.accepted ? Transform<Map, Camera>{T} : expected;
  return result;
}

}  // namespace amiss::mapping
