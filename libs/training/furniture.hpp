// Furniture of random sizes and looks, made here of boxes, cylinders and balls.
// in: kind, random stream     out: a static body at the origin (on the floor, x to the front), named after its kind, so
// that sim_worlds/classes.yaml knows its class. Where it may stand: against a wall, on the floor anywhere, on a wall,
// on other furniture.
#pragma once

#include <span>
#include <string_view>

#include "core/random.hpp"
#include "world/world.hpp"

namespace amiss::training {

enum class Stand { kAtWall, kAnywhere, kOnWall, kOnFurniture };

struct FurnitureKind {
  std::string_view name;  // of the body
  Stand stand = Stand::kAtWall;
  double often = 1.0;  // how often it is chosen, among those of the same stand
  world::Body (*make)(RandomStream&) = nullptr;
};

/// Seats, tables, storage, kitchen and bathroom, things on walls, permanent things on furniture.
[[nodiscard]] std::span<const FurnitureKind> seats();
[[nodiscard]] std::span<const FurnitureKind> storage();
[[nodiscard]] std::span<const FurnitureKind> decoration();
[[nodiscard]] std::span<const FurnitureKind> props();
/// A sink that sits on the board of a counter.
[[nodiscard]] world::Body random_sink(RandomStream& random);

}  // namespace amiss::training
