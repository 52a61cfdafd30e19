// A furnished corner and a way through it, for surface maps: frames with noise and a colour pattern.
#pragma once

#include <cmath>

#include "mapping/synthetic.hpp"

namespace amiss::mapping {

struct SurfaceRecording {
  std::vector<RgbdFrame> frames;
  std::vector<Transform<Map, Camera>> poses;
};

[[nodiscard]] inline TestScene surface_scene() {
  TestScene scene;
  scene.floor_z_m = 0.0;
  scene.boxes = {{{1.82, -3, 0}, {2.0, 3, 2.4}},
                 {{-1, 1.51, 0}, {3, 1.6, 2.4}},
                 {{1.03, 0.8, 0.38}, {1.72, 1.42, 0.42}},
                 {{1.2, -0.6, 0}, {1.7, -0.1, 0.45}}};
  scene.balls = {{{1.1, 0.3, 0.06}, 0.06}};
  return scene;
}

[[nodiscard]] inline SurfaceRecording surface_recording(int frames, bool noise, const CameraIntrinsics& camera) {
  SurfaceRecording r;
  RandomStream random(1, "surface");
  for (int i = 0; i < frames; ++i) {
    const double part = frames > 1 ? static_cast<double>(i) / (frames - 1) : 0.5;
    r.poses.push_back(camera_pose(-0.1 + 0.3 * part, -0.2 + 0.4 * part, -0.4 + 0.9 * part, -0.55));
    RgbdFrame frame = exact_frame(surface_scene(), r.poses.back(), camera);
    if (noise) frame = noisy_frame(frame, random);
    frame.colour.clear();
    for (std::size_t p = 0; p < frame.depth_m.size(); ++p) {
      const std::size_t u = p % static_cast<std::size_t>(camera.width);
      frame.colour.push_back({static_cast<std::uint8_t>(u * 255 / static_cast<std::size_t>(camera.width)), 120, 40});
    }
    r.frames.push_back(std::move(frame));
  }
  return r;
}

/// Signed distance to the scene's nearest surface [m], positive outside.
[[nodiscard]] inline double distance_to(const TestScene& scene, const Eigen::Vector3d& p) {
  double nearest = p.z() - scene.floor_z_m;
  for (const TestBox& box : scene.boxes) {
    const Eigen::Vector3d out = (box.low - p).cwiseMax(p - box.high);
    nearest = std::min(nearest, out.cwiseMax(0.0).norm() + std::min(out.maxCoeff(), 0.0));
  }
  for (const TestBall& ball : scene.balls) nearest = std::min(nearest, (p - ball.centre).norm() - ball.radius_m);
  return nearest;
}

}  // namespace amiss::mapping
