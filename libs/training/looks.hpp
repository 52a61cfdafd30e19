// Random materials: what things of a generated room look like.
// in: random stream     out: materials with a small texture of their own (stripes of wood, weave, speckles), never one
// of the pictures of sim_worlds
#pragma once

#include "core/random.hpp"
#include "world/world.hpp"

namespace amiss::training {

[[nodiscard]] world::Material random_wood(RandomStream& random);
[[nodiscard]] world::Material random_fabric(RandomStream& random);
[[nodiscard]] world::Material random_paint(RandomStream& random);    // white, grey or pastel, smooth
[[nodiscard]] world::Material random_plastic(RandomStream& random);  // any colour
[[nodiscard]] world::Material random_dark(RandomStream& random);     // screens, hobs
[[nodiscard]] world::Material random_leaf(RandomStream& random);
/// Many fields of different colours: books, pictures, printed boxes.
[[nodiscard]] world::Material random_print(RandomStream& random);
/// Of furniture: one of wood, paint and plastic.
[[nodiscard]] world::Material random_board(RandomStream& random);

}  // namespace amiss::training
