// Depth images of a floor, boxes and balls, computed ray by ray, with the noise of a structured-light camera.
#pragma once

#include <vector>

#include "core/random.hpp"
#include "core/sensors.hpp"

namespace amiss::mapping {

struct TestBox {
  Eigen::Vector3d low, high;
};
struct TestBall {
  Eigen::Vector3d centre;
  double radius_m = 0.0;
};
/// Things in the map frame; the floor is the plane z = floor_z_m.
struct TestScene {
  double floor_z_m = -0.012;
  std::vector<TestBox> boxes;
  std::vector<TestBall> balls;
};

/// The robot's camera at (x, y, height) that looks along yaw, tilted (negative: down).
[[nodiscard]] Transform<Map, Camera> camera_pose(double x_m, double y_m, double yaw_rad, double tilt_rad,
                                                 double height_m = 0.97 - 0.012);

[[nodiscard]] RgbdFrame exact_frame(const TestScene& scene, const Transform<Map, Camera>& T_map_camera,
                                    const CameraIntrinsics& camera = {});

/// Axial and lateral noise by Nguyen et al. 2012 and disparity in steps of an eighth of a pixel.
[[nodiscard]] RgbdFrame noisy_frame(const RgbdFrame& exact, RandomStream& random);

/// A camera a quarter as wide and high, for tests that need not be fine.
[[nodiscard]] CameraIntrinsics small_camera();

/// What that camera sees of a wall of one colour, straight ahead.
[[nodiscard]] RgbdFrame wall_frame(float z_m, Rgb colour);

}  // namespace amiss::mapping
