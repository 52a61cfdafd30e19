#include "segment/internal/window.hpp"

#include <algorithm>
#include <limits>

namespace amiss::segment::internal {

namespace {

constexpr int kBorder = 2;              // pixels around the crop, to see what continues outside
constexpr float kSameSurface = 0.015F;  // relative depth step of neighbours that are averaged

struct Box {
  int u0, v0, u1, v1;  // inclusive
};

/// The pixels that the crop's bounding box covers; the whole image where a part of it is behind the camera.
Box box_of(const CameraIntrinsics& k, const Transform<Map, Camera>& T_map_camera, const Cylinder& crop) {
  const Box whole{0, 0, k.width - 1, k.height - 1};
  if (!std::isfinite(crop.radius_m)) return whole;
  const Eigen::Isometry3d T_camera_map = T_map_camera.T.inverse();
  double u0 = std::numeric_limits<double>::infinity(), v0 = u0, u1 = -u0, v1 = -u0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d p_map(crop.centre_map.x() + ((corner & 1) != 0 ? 1.0 : -1.0) * crop.radius_m,
                                crop.centre_map.y() + ((corner & 2) != 0 ? 1.0 : -1.0) * crop.radius_m,
                                (corner & 4) != 0 ? crop.z_high_m : crop.z_low_m);
    const Eigen::Vector3d p = T_camera_map * p_map;
    if (p.z() < 0.1) return whole;
    const double u = k.fx * p.x() / p.z() + k.cx, v = k.fy * p.y() / p.z() + k.cy;
    u0 = std::min(u0, u), u1 = std::max(u1, u), v0 = std::min(v0, v), v1 = std::max(v1, v);
  }
  const auto clamped = [](double pixel, int size) {
    return static_cast<int>(std::clamp(pixel, -1.0, static_cast<double>(size)));
  };
  return {std::max(0, clamped(std::floor(u0), k.width) - kBorder),
          std::max(0, clamped(std::floor(v0), k.height) - kBorder),
          std::min(k.width - 1, clamped(std::ceil(u1), k.width) + kBorder),
          std::min(k.height - 1, clamped(std::ceil(v1), k.height) + kBorder)};
}

bool is_inside(const Cylinder& crop, const Eigen::Vector3f& p_map) {
  const Eigen::Vector3d p = p_map.cast<double>();
  if (p.z() < crop.z_low_m || p.z() > crop.z_high_m) return false;
  return !std::isfinite(crop.radius_m) ||
         (p.head<2>() - crop.centre_map).squaredNorm() <= crop.radius_m * crop.radius_m;
}

/// Mean of the 3x3 depths that are near the middle one.
float smoothed_depth(const Window& w, int x, int y) {
  const float middle = w.range_m[w.index(x, y)];
  float sum = 0.0F, n = 0.0F;
  for (int dy = std::max(0, y - 1); dy <= std::min(w.height - 1, y + 1); ++dy) {
    for (int dx = std::max(0, x - 1); dx <= std::min(w.width - 1, x + 1); ++dx) {
      const float z = w.range_m[w.index(dx, dy)];
      if (!(std::abs(z - middle) < kSameSurface * middle)) continue;
      sum += z;
      n += 1.0F;
    }
  }
  return sum / n;
}

}  // namespace

Window window_of(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera, const Cylinder& crop,
                 double max_range_m) {
  const CameraIntrinsics& k = frame.intrinsics;
  const Box box = box_of(k, T_map_camera, crop);
  Window w;
  w.u0 = box.u0, w.v0 = box.v0;
  w.width = std::max(0, box.u1 - box.u0 + 1), w.height = std::max(0, box.v1 - box.v0 + 1);
  w.frame_width = k.width, w.frame_height = k.height;
  const Eigen::Matrix3f R = T_map_camera.T.rotation().cast<float>();
  w.camera_map = T_map_camera.T.translation().cast<float>();
  const std::size_t n = static_cast<std::size_t>(w.width) * static_cast<std::size_t>(w.height);
  w.where.assign(n, Where::kNothing);
  w.points.assign(n, Eigen::Vector3f::Zero());
  w.smooth.assign(n, Eigen::Vector3f::Zero());
  w.colours.resize(n);
  w.range_m.assign(n, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t pixel = w.pixel_of(i);
    w.colours[i] = frame.colour[pixel];
    const float z = frame.depth_m[pixel];
    if (z > 0.0F && static_cast<double>(z) <= max_range_m) w.range_m[i] = z;
  }
  for (int y = 0; y < w.height; ++y) {
    for (int x = 0; x < w.width; ++x) {
      const std::size_t i = w.index(x, y);
      const float z = w.range_m[i];
      if (std::isnan(z)) continue;
      const Eigen::Vector3f ray_map = R * Eigen::Vector3f(static_cast<float>((w.u0 + x - k.cx) / k.fx),
                                                          static_cast<float>((w.v0 + y - k.cy) / k.fy), 1.0F);
      w.points[i] = w.camera_map + z * ray_map;
      w.smooth[i] = w.camera_map + smoothed_depth(w, x, y) * ray_map;
      w.where[i] = is_inside(crop, w.points[i]) ? Where::kInside : Where::kOutside;
    }
  }
  return w;
}

}  // namespace amiss::segment::internal
