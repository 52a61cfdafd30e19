#include "mapping/synthetic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace amiss::mapping {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

double to_box(const TestBox& box, const Eigen::Vector3d& from, const Eigen::Vector3d& ray) {
  double enter = 0.0, leave = kNone;
  for (int i = 0; i < 3; ++i) {
    const double a = (box.low[i] - from[i]) / ray[i], b = (box.high[i] - from[i]) / ray[i];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave && enter > 0.0 ? enter : kNone;
}

double to_ball(const TestBall& ball, const Eigen::Vector3d& from, const Eigen::Vector3d& ray) {
  const Eigen::Vector3d off = from - ball.centre;
  const double a = ray.squaredNorm(), b = off.dot(ray), c = off.squaredNorm() - ball.radius_m * ball.radius_m;
  const double under = b * b - a * c;
  return under >= 0.0 && -b - std::sqrt(under) > 0.0 ? (-b - std::sqrt(under)) / a : kNone;
}

double to_scene(const TestScene& scene, const Eigen::Vector3d& from, const Eigen::Vector3d& ray) {
  double nearest = ray.z() < 0.0 ? (scene.floor_z_m - from.z()) / ray.z() : kNone;
  for (const TestBox& box : scene.boxes) nearest = std::min(nearest, to_box(box, from, ray));
  for (const TestBall& ball : scene.balls) nearest = std::min(nearest, to_ball(ball, from, ray));
  return nearest;
}

/// Normal numbers from a table, from a random place on: a frame asks for a million.
class QuickNormals {
 public:
  explicit QuickNormals(RandomStream& random) : at_(random.below(kSize)) {}
  double operator()() { return static_cast<double>(table()[at_++ & (kSize - 1)]); }

 private:
  static constexpr std::size_t kSize = std::size_t{1} << 20;
  static const std::vector<float>& table() {
    static const std::vector<float> normals = [] {
      RandomStream random(1, "normals");
      std::vector<float> numbers(kSize);
      for (float& n : numbers) n = static_cast<float>(random.normal());
      return numbers;
    }();
    return normals;
  }
  std::size_t at_;
};

}  // namespace

Transform<Map, Camera> camera_pose(double x_m, double y_m, double yaw_rad, double tilt_rad, double height_m) {
  Eigen::Matrix3d optical;  // columns: right, down, forward
  optical << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  Transform<Map, Camera> T;
  T.T.linear() =
      (Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(-tilt_rad, Eigen::Vector3d::UnitY()))
          .toRotationMatrix() *
      optical;
  T.T.translation() = Eigen::Vector3d(x_m, y_m, height_m);
  return T;
}

RgbdFrame exact_frame(const TestScene& scene, const Transform<Map, Camera>& T, const CameraIntrinsics& camera) {
  RgbdFrame frame;
  frame.intrinsics = camera;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Eigen::Vector3d ray((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
      const double depth = to_scene(scene, T.position(), T.T.linear() * ray);
      frame.depth_m.push_back(depth < 20.0 ? static_cast<float>(depth) : std::numeric_limits<float>::quiet_NaN());
    }
  }
  return frame;
}

RgbdFrame noisy_frame(const RgbdFrame& exact, RandomStream& random) {
  constexpr double kBaselineM = 0.075, kSubpixel = 0.125, kLateralPx = 0.8;
  const CameraIntrinsics& k = exact.intrinsics;
  const double lateral = kLateralPx * k.fx / 538.39;
  QuickNormals normal(random);
  RgbdFrame noisy = exact;
  for (int v = 0; v < k.height; ++v) {
    for (int u = 0; u < k.width; ++u) {
      const int near_u = std::clamp(u + static_cast<int>(std::lround(lateral * random.normal())), 0, k.width - 1);
      const int near_v = std::clamp(v + static_cast<int>(std::lround(lateral * random.normal())), 0, k.height - 1);
      const double z = double{exact.depth_m[static_cast<std::size_t>(near_v * k.width + near_u)]};
      const double blurred = z + (0.0012 + 0.0019 * (z - 0.4) * (z - 0.4)) * normal();
      const double focal = 538.39;
      const double disparity = std::round(focal * kBaselineM / blurred / kSubpixel) * kSubpixel;
      const bool seen = std::isfinite(z) && z >= 0.4 && z <= 8.0 && disparity > 0.0;
      noisy.depth_m[static_cast<std::size_t>(v * k.width + u)] =
          seen ? static_cast<float>(focal * kBaselineM / disparity) : std::numeric_limits<float>::quiet_NaN();
    }
  }
  return noisy;
}

CameraIntrinsics small_camera() {
  const CameraIntrinsics full;
  return {160, 120, full.fx / 4, full.fy / 4, full.cx / 4, full.cy / 4};
}

RgbdFrame wall_frame(float z_m, Rgb colour) {
  RgbdFrame frame;
  frame.intrinsics = small_camera();
  const auto pixels =
      static_cast<std::size_t>(frame.intrinsics.width) * static_cast<std::size_t>(frame.intrinsics.height);
  frame.depth_m.assign(pixels, z_m);
  frame.colour.assign(pixels, colour);
  return frame;
}

}  // namespace amiss::mapping
