// How a thing that is let go comes to rest.
#pragma once

#include "core/random.hpp"
#include "sim/physics.hpp"

namespace amiss::sim::internal {

/// How a thing comes to lie: as it was made (every second time), or as it happens to fall.
[[nodiscard]] Eigen::Isometry3d random_turn(RandomStream& random);

/// The body, free to fall, turned so at the world's origin, and its bounds there.
struct Turned {
  world::Body body;
  Eigen::AlignedBox3d bounds;
};
[[nodiscard]] Turned turned(const world::Body& body, const Eigen::Isometry3d& turn);

/// Lets time pass until the body sleeps, for 6 s at most; whether it sleeps.
bool settle(Physics& physics, std::size_t body);
/// The same for all bodies.
bool settle(Physics& physics);

}  // namespace amiss::sim::internal
