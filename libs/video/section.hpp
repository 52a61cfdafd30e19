// A house cut open, so that one can look into it from above: what of a body is tall (walls, ceilings, curtains) ends at
// a height; what hangs above it is left out. Body of a world -> body with other visuals. World frame, metres. The cut
// faces of meshes look dark: the inside of each surface gets a dark lining.
#pragma once

#include "world/world.hpp"

namespace amiss::video {

struct Section {
  double tall_m = 2.0;    // shapes that reach higher are cut
  double height_m = 1.0;  // here
};

[[nodiscard]] world::Body cut_open(world::Body body, const Section& section = {});

}  // namespace amiss::video
