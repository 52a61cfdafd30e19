// A room with a table and what stands on it, a shelf, a bench, and a few toys to be put there.
#pragma once

#include "sim/rooms.hpp"
#include "sim/scatter.hpp"
#include "world/catalogue.hpp"
#include "world/class_table.hpp"

namespace amiss::sim::test {

inline world::World furnished_room() {
  world::World world = room(4, 4);
  world::Body table = block("table_1", {0.8, 1.2, 0.04}, {2.0, 0.65, 0.73});
  world::Shape leg;
  leg.geometry = world::Box{{0.1, 0.1, 0.71}};
  leg.T_body_shape.translation() = Eigen::Vector3d(0.0, 0.0, -0.375);
  table.collisions.push_back(leg);
  table.visuals.push_back(leg);
  world.bodies.push_back(table);
  world.bodies.push_back(block("monitor_1", {0.1, 0.5, 0.4}, {1.8, 0.65, 0.95}));
  world.bodies.push_back(block("bench_1", {0.4, 1.2, 0.45}, {0.3, 2.5, 0.225}));
  world.bodies.push_back(block("shelf_1", {0.9, 0.35, 0.02}, {3.0, 3.75, 0.49}));
  world.bodies.push_back(block("shelf_2", {0.9, 0.35, 0.02}, {3.0, 3.75, 0.89}));
  return world;
}

inline world::Catalogue toys() {
  const auto entry = [](const char* name, const world::Geometry& geometry) {
    return world::CatalogueEntry{name, name, body(name, geometry, {0, 0, 0}, false), {}};
  };
  world::Catalogue catalogue;
  catalogue.entries = {entry("ball", world::Sphere{0.05}),
                       entry("brick", world::Box{{0.1, 0.06, 0.05}}),
                       entry("can", world::Cylinder{0.033, 0.12}),
                       entry("carton", world::Box{{0.06, 0.16, 0.21}}),
                       entry("cube", world::Box{{0.06, 0.06, 0.06}}),
                       entry("disc", world::Cylinder{0.1, 0.02}),
                       entry("mug", world::Cylinder{0.04, 0.09}),
                       entry("tin", world::Cylinder{0.05, 0.05})};
  return catalogue;
}

inline world::ClassTable classes() {
  return world::ClassTable({{"floor", SemanticClass::kFloor},
                            {"wall", SemanticClass::kWall},
                            {"table", SemanticClass::kTable},
                            {"shelf", SemanticClass::kBookshelf},
                            {"bench", SemanticClass::kOtherFurniture},
                            {"monitor", SemanticClass::kOtherProp}});
}

/// The world with the objects as bodies of it.
inline world::World with_objects(world::World world, const std::vector<ScatteredObject>& objects,
                                 const world::Catalogue& catalogue) {
  for (const ScatteredObject& object : objects) {
    world.bodies.push_back(catalogue.at(object.kind).body);
    world.bodies.back().name = object.name;
    world.bodies.back().pose = object.pose;
  }
  return world;
}

}  // namespace amiss::sim::test
