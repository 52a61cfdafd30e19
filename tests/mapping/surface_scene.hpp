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

/// Floor, a wall and up to four boxes and two balls before the camera, some of them beyond two metres.
[[nodiscard]] inline TestScene random_scene(RandomStream& random, const Transform<Map, Camera>& T_map_camera) {
  TestScene scene;
  scene.floor_z_m = 0.0;
  const auto ahead = [&](double near_m, double far_m) {
    const Eigen::Vector3d p(random.uniform(-0.7, 0.7), random.uniform(-0.5, 0.5), 1.0);
    return Eigen::Vector3d(T_map_camera.T * (p * random.uniform(near_m, far_m)));
  };
  const auto box = [&](const Eigen::Vector3d& low, double edge_m) {
    const Eigen::Vector3d edges(random.uniform(0.05, edge_m), random.uniform(0.05, edge_m),
                                random.uniform(0.05, edge_m));
    scene.boxes.push_back({low, low + edges});
  };
  for (std::uint64_t i = random.below(5); i > 0; --i) box(ahead(0.9, 2.5), 0.8);
  for (std::uint64_t i = random.below(3); i > 0; --i)
    scene.balls.push_back({ahead(0.9, 2.0), random.uniform(0.03, 0.2)});
  const Eigen::Vector3d wall = ahead(1.5, 3.0);
  scene.boxes.push_back({{wall.x(), wall.y() - 4, 0}, {wall.x() + 0.1, wall.y() + 4, 2.5}});
  return scene;
}

/// A pattern of colours, smooth from pixel to pixel.
inline void paint(RgbdFrame& frame) {
  const auto width = static_cast<std::size_t>(frame.intrinsics.width);
  frame.colour.clear();
  for (std::size_t p = 0; p < frame.depth_m.size(); ++p) {
    frame.colour.push_back({static_cast<std::uint8_t>(p % width * 255 / width), 120,
                            static_cast<std::uint8_t>(p * 255 / frame.depth_m.size())});
  }
}

[[nodiscard]] inline SurfaceRecording surface_recording(int frames, bool noise, const CameraIntrinsics& camera) {
  SurfaceRecording r;
  RandomStream random(1, "surface");
  for (int i = 0; i < frames; ++i) {
    const double part = frames > 1 ? static_cast<double>(i) / (frames - 1) : 0.5;
    r.poses.push_back(camera_pose(-0.1 + 0.3 * part, -0.2 + 0.4 * part, -0.4 + 0.9 * part, -0.55));
    RgbdFrame frame = exact_frame(surface_scene(), r.poses.back(), camera);
    if (noise) frame = noisy_frame(frame, random);
    paint(frame);
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
