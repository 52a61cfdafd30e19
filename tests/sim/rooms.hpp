// Small worlds and a robot, put together by hand.
#pragma once

#include <string>

#include "robot/model.hpp"
#include "world/world.hpp"

namespace amiss::sim::test {

inline world::Body body(std::string name, const world::Geometry& geometry, const Eigen::Vector3d& at, bool is_static) {
  world::Body made;
  made.name = std::move(name);
  made.pose.T.translation() = at;
  made.is_static = is_static;
  made.mass_kg = 0.3;
  world::Shape shape;
  shape.geometry = geometry;
  made.visuals = {shape};
  made.collisions = {shape};
  return made;
}

inline world::Body block(std::string name, const Eigen::Vector3d& size, const Eigen::Vector3d& at,
                         bool is_static = true) {
  return body(std::move(name), world::Box{size}, at, is_static);
}

/// A floor from (0, 0) to (x, y) with four walls of 10 cm, 2.5 m high, round it.
inline world::World room(double x, double y) {
  world::World room;
  room.name = "room";
  room.bodies.push_back(block("floor", {x + 1, y + 1, 0.1}, {x / 2, y / 2, -0.05}));
  room.bodies.push_back(block("wall_west", {0.1, y + 0.2, 2.5}, {-0.05, y / 2, 1.25}));
  room.bodies.push_back(block("wall_east", {0.1, y + 0.2, 2.5}, {x + 0.05, y / 2, 1.25}));
  room.bodies.push_back(block("wall_south", {x, 0.1, 2.5}, {x / 2, -0.05, 1.25}));
  room.bodies.push_back(block("wall_north", {x, 0.1, 2.5}, {x / 2, y + 0.05, 1.25}));
  return room;
}

inline robot::Link cylinder_link(std::string name, double radius, double length, double z) {
  robot::LinkShape shape;
  shape.kind = robot::LinkShape::Kind::kCylinder;
  shape.dimensions = {radius, length, 0};
  shape.T_link_shape.translation().z() = z;
  return {std::move(name), {shape}, {shape}};
}

/// A base of 0.22 m radius and a head on a neck with the joints of the real one.
inline robot::Model small_robot() {
  robot::Model model;
  model.name = "small";
  model.links = {cylinder_link("base_link", 0.22, 0.7, 0.35), {"neck", {}, {}}, cylinder_link("head", 0.1, 0.2, 0.05)};
  robot::Joint pan;
  pan.name = "head_pan_joint";
  pan.kind = robot::Joint::Kind::kRevolute;
  pan.parent = 0;
  pan.child = 1;
  pan.T_parent_joint.translation().z() = 0.85;
  pan.lower = -3.84;
  pan.upper = 1.75;
  pan.velocity = 1.0;
  robot::Joint tilt = pan;
  tilt.name = "head_tilt_joint";
  tilt.parent = 1;
  tilt.child = 2;
  tilt.T_parent_joint = Eigen::Isometry3d::Identity();
  tilt.axis = -Eigen::Vector3d::UnitY();
  tilt.lower = -1.57;
  tilt.upper = 0.52;
  model.joints = {pan, tilt};
  model.T_base_laser.T.translation() = Eigen::Vector3d(0.1675, 0, 0.184);
  return model;
}

inline Transform<amiss::World, Object> at(double x, double y, double z) {
  Transform<amiss::World, Object> pose;
  pose.T.translation() = Eigen::Vector3d(x, y, z);
  return pose;
}

}  // namespace amiss::sim::test
