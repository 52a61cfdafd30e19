// Small worlds made by hand for the tests of the camera.
#pragma once

#include <string>
#include <utility>

#include "sim/renderer.hpp"

namespace amiss::sim {

inline world::Body coloured_body(std::string name, world::Geometry geometry, const Eigen::Vector3d& at,
                                 const Eigen::Vector3f& colour) {
  world::Body body;
  body.name = std::move(name);
  body.pose.T.translation() = at;
  world::Shape shape;
  shape.geometry = std::move(geometry);
  shape.material.diffuse = colour;
  body.visuals.push_back(std::move(shape));
  return body;
}

inline const Eigen::Vector3f kRed(0.9F, 0.1F, 0.1F), kGreen(0.1F, 0.9F, 0.1F), kBlue(0.1F, 0.1F, 0.9F),
    kWhite(0.9F, 0.9F, 0.9F);

/// At the origin of the world's floor plan, `height` above it, looking along +x and down by `pitch`.
inline Transform<amiss::World, Camera> eye_at(double height_m, double pitch_rad = 0.0) {
  return look_at({{0, 0, height_m}}, {{std::cos(pitch_rad), 0, height_m - std::sin(pitch_rad)}});
}

inline std::size_t pixel(const CameraIntrinsics& c, int u, int v) {
  return static_cast<std::size_t>(v) * static_cast<std::size_t>(c.width) + static_cast<std::size_t>(u);
}

}  // namespace amiss::sim
