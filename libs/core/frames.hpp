// Frames in types: Transform<To, From> carries points of frame From into frame To, so that neighbours cancel:
// p_map = T_map_base * T_base_camera * p_camera. Lengths in metres, angles in radians.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace amiss {

struct World {};   // the simulator's own frame; only world, sim, score and apps know it
struct Map {};     // the frame of the robot's maps; z = 0 is the floor
struct Odom {};    // smooth, drifts
struct Base {};    // on the floor in the middle of the base, x forward, y left, z up
struct Camera {};  // optical: x right, y down, z forward
struct Laser {};   // x forward, y left, z up
struct Object {};

/// A point of frame In [m].
template <class In>
struct Point {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
};

/// A rigid transform that carries points of From into To.
template <class To, class From>
struct Transform {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();

  [[nodiscard]] Transform<From, To> inverse() const { return {T.inverse()}; }
  [[nodiscard]] Eigen::Vector3d position() const { return T.translation(); }
};

template <class To, class Via, class From>
[[nodiscard]] Transform<To, From> operator*(const Transform<To, Via>& a, const Transform<Via, From>& b) {
  return {a.T * b.T};
}
template <class To, class From>
[[nodiscard]] Point<To> operator*(const Transform<To, From>& a, const Point<From>& b) {
  return {a.T * b.p};
}

/// The same angle in (-pi, pi].
[[nodiscard]] inline double wrap_angle(double angle_rad) {
  const double wrapped = std::remainder(angle_rad, 2.0 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}
[[nodiscard]] constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }
[[nodiscard]] constexpr double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

/// A rigid transform on the floor, yaw in (-pi, pi].
template <class To, class From>
struct Pose2 {
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;

  [[nodiscard]] Eigen::Vector2d position() const { return {x_m, y_m}; }
  [[nodiscard]] Pose2<From, To> inverse() const {
    const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
    return {-c * x_m - s * y_m, s * x_m - c * y_m, wrap_angle(-yaw_rad)};
  }
  [[nodiscard]] Transform<To, From> lift() const {
    Transform<To, From> lifted;
    lifted.T.translate(Eigen::Vector3d(x_m, y_m, 0.0));
    lifted.T.rotate(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
    return lifted;
  }
};

template <class To, class Via, class From>
[[nodiscard]] Pose2<To, From> operator*(const Pose2<To, Via>& a, const Pose2<Via, From>& b) {
  const double c = std::cos(a.yaw_rad), s = std::sin(a.yaw_rad);
  return {a.x_m + c * b.x_m - s * b.y_m, a.y_m + s * b.x_m + c * b.y_m, wrap_angle(a.yaw_rad + b.yaw_rad)};
}

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Rgb&) const = default;
};

/// Points of frame In [m]; colours and normals are either empty or as long as the points.
template <class In>
struct Cloud {
  std::vector<Eigen::Vector3f> points;
  std::vector<Rgb> colours;
  std::vector<Eigen::Vector3f> normals;
};

}  // namespace amiss
