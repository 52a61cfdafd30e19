// A body put together from boxes, cylinders and balls, each to be seen and to be felt.
// Local frame as for the furniture of sim_worlds: origin on the floor in the middle of the footprint, x to the front.
#pragma once

#include <string>

#include "world/world.hpp"

namespace amiss::training {

class Piece {
 public:
  explicit Piece(std::string name) { body_.name = std::move(name); }

  Piece& box(const Eigen::Vector3d& size, const Eigen::Vector3d& middle, const world::Material& look,
             const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity()) {
    return add(world::Box{size}, middle, look, turn);
  }
  /// Along z.
  Piece& cylinder(double radius, double length, const Eigen::Vector3d& middle, const world::Material& look,
                  const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity()) {
    return add(world::Cylinder{radius, length}, middle, look, turn);
  }
  Piece& ball(double radius, const Eigen::Vector3d& middle, const world::Material& look) {
    return add(world::Sphere{radius}, middle, look, Eigen::Quaterniond::Identity());
  }
  [[nodiscard]] world::Body take() { return std::move(body_); }

 private:
  Piece& add(const world::Geometry& geometry, const Eigen::Vector3d& middle, const world::Material& look,
             const Eigen::Quaterniond& turn) {
    world::Shape shape{geometry, Eigen::Isometry3d::Identity(), look};
    shape.T_body_shape.translate(middle).rotate(turn);
    body_.visuals.push_back(shape);
    body_.collisions.push_back(shape);
    return *this;
  }

  world::Body body_;
};

/// A turn about an axis of the body.
[[nodiscard]] inline Eigen::Quaterniond turned(double angle_rad, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, axis));
}

}  // namespace amiss::training
