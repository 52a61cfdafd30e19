// What the made-up rooms of the tests are made of.
#pragma once

#include "world/catalogue.hpp"
#include "world/class_table.hpp"

namespace amiss::training::test {

inline const world::ClassTable& classes() {
  static const world::ClassTable kTable =
      world::load_class_table(std::filesystem::path(AMISS_SOURCE_DIR) / "sim_worlds" / "classes.yaml");
  return kTable;
}

inline world::Catalogue toys() {
  world::Catalogue catalogue;
  world::Body can;
  can.name = "can";
  can.is_static = false;
  world::Shape shape;
  shape.geometry = world::Cylinder{0.035, 0.11};
  shape.material.diffuse = {0.8F, 0.1F, 0.1F};
  can.visuals = can.collisions = {shape};
  catalogue.entries.push_back({"can", "can", can, {0.07, 0.07, 0.11}});
  return catalogue;
}

}  // namespace amiss::training::test
