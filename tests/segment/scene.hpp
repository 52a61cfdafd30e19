// A floor with simple bodies on it, seen by a depth camera with the noise of structured light: what the tests of
// segmentation look at. The real floor lies 0.012 m under the map's z = 0.
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "core/random.hpp"
#include "core/sensors.hpp"

namespace amiss::testing {

constexpr double kFloorZ = -0.012;

/// A box or an ellipsoid with its axes turned about z.
struct Body {
  enum class Kind { kBox, kEllipsoid } kind = Kind::kBox;
  Eigen::Vector3d centre_map = Eigen::Vector3d::Zero();
  Eigen::Vector3d size_m = Eigen::Vector3d::Ones();
  double yaw_rad = 0.0;
  Rgb colour;
  int object = 0;  // bodies of one object share the number

  [[nodiscard]] std::optional<double> hit(const Eigen::Vector3d& from, const Eigen::Vector3d& dir) const {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(-yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Eigen::Vector3d half = size_m / 2.0;
    const Eigen::Vector3d o = (R * (from - centre_map)).cwiseQuotient(half), d = (R * dir).cwiseQuotient(half);
    if (kind == Kind::kEllipsoid) {
      const double a = d.squaredNorm(), b = o.dot(d), c = o.squaredNorm() - 1.0, root = b * b - a * c;
      if (root < 0.0 || -b - std::sqrt(root) < 0.0) return std::nullopt;
      return (-b - std::sqrt(root)) / a;
    }
    double enter = 0.0, leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const double t0 = (-1.0 - o[axis]) / d[axis], t1 = (1.0 - o[axis]) / d[axis];
      enter = std::max(enter, std::min(t0, t1));
      leave = std::min(leave, std::max(t0, t1));
    }
    return enter < leave && enter > 0.0 ? std::optional<double>(enter) : std::nullopt;
  }
};

struct View {
  RgbdFrame frame;
  Transform<Map, Camera> T_map_camera;
  std::vector<int> objects;  // of each pixel; 0 is the floor
};

/// On the floor at (x, y).
[[nodiscard]] inline Body box_at(double x, double y, const Eigen::Vector3d& size_m, double yaw_rad, Rgb colour,
                                 int object = 1) {
  return {Body::Kind::kBox, {x, y, kFloorZ + size_m.z() / 2.0}, size_m, yaw_rad, colour, object};
}
[[nodiscard]] inline Body ellipsoid_at(double x, double y, const Eigen::Vector3d& size_m, double yaw_rad, Rgb colour,
                                       int object = 1, double above_m = 0.0) {
  return {Body::Kind::kEllipsoid, {x, y, kFloorZ + above_m + size_m.z() / 2.0}, size_m, yaw_rad, colour, object};
}

/// The camera 0.98 m above the map's origin, looking along +x and down.
[[nodiscard]] inline View look(const std::vector<Body>& bodies, double tilt_rad, std::uint64_t seed,
                               bool noise = true) {
  View view;
  Eigen::Matrix3d R;  // columns: camera x right, y down, z forward, in the map
  R.col(0) = Eigen::Vector3d(0.0, -1.0, 0.0);
  R.col(2) = Eigen::Vector3d(std::cos(tilt_rad), 0.0, std::sin(tilt_rad));
  R.col(1) = R.col(2).cross(R.col(0));
  view.T_map_camera.T.linear() = R;
  view.T_map_camera.T.translation() = Eigen::Vector3d(0.0, 0.0, 0.98);
  RandomStream random(seed, "depth");
  const CameraIntrinsics& k = view.frame.intrinsics;
  const Eigen::Vector3d from = view.T_map_camera.position();
  for (int v = 0; v < k.height; ++v) {
    for (int u = 0; u < k.width; ++u) {
      const Eigen::Vector3d dir = R * Eigen::Vector3d((u - k.cx) / k.fx, (v - k.cy) / k.fy, 1.0);
      double z = dir.z() < 0.0 ? (kFloorZ - from.z()) / dir.z() : std::numeric_limits<double>::infinity();
      Rgb colour{150, 140, 130};
      int object = 0;
      for (const Body& body : bodies) {
        const auto hit = body.hit(from, dir);
        if (!hit || *hit >= z) continue;
        z = *hit;
        colour = body.colour;
        object = body.object;
      }
      const bool seen = z >= 0.4 && z < 8.0;
      if (noise && seen) z += (0.0012 + 0.0019 * (z - 0.4) * (z - 0.4)) * random.normal();
      view.frame.depth_m.push_back(seen ? static_cast<float>(z) : std::numeric_limits<float>::quiet_NaN());
      view.frame.colour.push_back(colour);
      view.objects.push_back(seen ? object : -1);
    }
  }
  return view;
}

}  // namespace amiss::testing
