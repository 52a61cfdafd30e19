// A world's content as a hash: the same for the same geometry, materials, masses and places, wherever its files lie.
#pragma once

#include <string>

#include "world/world.hpp"

namespace amiss::world {

/// SHA-256 in hex over all bodies, lights and the start of the robot; names of files do not count.
[[nodiscard]] std::string fingerprint(const World& world);

}  // namespace amiss::world
