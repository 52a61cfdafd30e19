// Lamps, plants, bins; what hangs on walls and what is built into them.
#include <array>
#include <numbers>

#include "training/furniture.hpp"
#include "training/looks.hpp"
#include "training/piece.hpp"

namespace amiss::training {

namespace {

using Eigen::Vector3d;

world::Body floor_lamp(RandomStream& random) {
  const world::Material metal = random_dark(random), shade = random_paint(random);
  const double height = random.uniform(1.3, 1.8), radius = random.uniform(0.12, 0.24);
  Piece piece("lamp_floor");
  piece.cylinder(random.uniform(0.1, 0.17), 0.03, {0, 0, 0.015}, metal);
  piece.cylinder(0.014, height, {0, 0, height / 2}, metal);
  piece.cylinder(radius, random.uniform(0.18, 0.35), {0, 0, height}, shade);
  return piece.take();
}

/// Leaves are thin boxes that lean outwards from a stem.
void add_leaves(Piece& piece, double low_m, double high_m, double reach_m, RandomStream& random) {
  const int leaves = 12 + static_cast<int>(random.below(24));
  for (int i = 0; i < leaves; ++i) {
    const double angle = random.uniform(0, 2 * std::numbers::pi), out = random.uniform(0.3, 1.0) * reach_m;
    const double length = reach_m * random.uniform(0.5, 0.9);
    const Vector3d middle(out * 0.6 * std::cos(angle), out * 0.6 * std::sin(angle), random.uniform(low_m, high_m));
    piece.box({length, length * random.uniform(0.3, 0.6), 0.006}, middle, random_leaf(random),
              turned(angle, Vector3d::UnitZ()) * turned(random.uniform(-0.9, 0.5), Vector3d::UnitY()));
  }
}

world::Body tall_plant(RandomStream& random) {
  const double pot = random.uniform(0.25, 0.4), radius = random.uniform(0.12, 0.2), height = random.uniform(0.8, 1.6);
  Piece piece("plant_tall");
  piece.cylinder(radius, pot, {0, 0, pot / 2}, random_plastic(random));
  piece.cylinder(0.02, height - pot, {0, 0, (height + pot) / 2}, random_wood(random));
  add_leaves(piece, pot + 0.15, height, random.uniform(0.2, 0.4), random);
  return piece.take();
}

world::Body bin(RandomStream& random) {
  const world::Material look = random.uniform() < 0.5 ? random_plastic(random) : random_fabric(random);
  const bool large = random.uniform() < 0.5;
  const double radius = large ? random.uniform(0.17, 0.24) : random.uniform(0.1, 0.16);
  const double height = large ? random.uniform(0.4, 0.6) : random.uniform(0.25, 0.4);
  Piece piece(large ? "basket" : "bin");
  if (random.uniform() < 0.5) {
    piece.cylinder(radius, height, {0, 0, height / 2}, look);
  } else {
    for (const double side : {-1.0, 1.0}) {
      piece.box({2 * radius, 0.01, height}, {0, side * radius, height / 2}, look);
      piece.box({0.01, 2 * radius, height}, {side * radius, 0, height / 2}, look);
    }
    piece.box({2 * radius, 2 * radius, 0.01}, {0, 0, 0.01}, look);
  }
  return piece.take();
}

world::Body coat_rack(RandomStream& random) {
  Piece piece("coat_rack");
  piece.box({0.03, 1.0, 0.1}, {0.015, 0, 1.7}, random_wood(random));
  for (double y = -0.4; y <= 0.4; y += random.uniform(0.2, 0.35)) {
    piece.box({0.1, random.uniform(0.15, 0.3), random.uniform(0.5, 0.9)}, {0.07, y, 1.3}, random_fabric(random));
  }
  return piece.take();
}

world::Body mirror(RandomStream& random) {
  Piece piece("mirror");
  const double low = random.uniform(0.3, 1.1), height = random.uniform(0.6, 1.3);
  piece.box({0.025, random.uniform(0.4, 0.7), height}, {0.0125, 0, low + height / 2}, random_paint(random));
  return piece.take();
}

world::Body picture(RandomStream& random) {
  const double width = random.uniform(0.3, 1.0), height = random.uniform(0.3, 0.9), z = random.uniform(1.3, 1.7);
  Piece piece("picture");
  piece.box({0.02, width, height}, {0.01, 0, z}, random_board(random));
  piece.box({0.004, width - 0.06, height - 0.06}, {0.022, 0, z}, random_print(random));
  return piece.take();
}

void add_frame(Piece& piece, double width, double low, double high, double thickness, const world::Material& look) {
  const double middle = (low + high) / 2;
  for (const double side : {-1.0, 1.0}) {
    piece.box({thickness, 0.07, high - low}, {thickness / 2, side * width / 2, middle}, look);
  }
  piece.box({thickness, width, 0.07}, {thickness / 2, 0, high}, look);
}

world::Body window(RandomStream& random) {
  const world::Material frame = random.uniform() < 0.7 ? random_paint(random) : random_wood(random);
  const double width = random.uniform(0.8, 2.0), low = random.uniform(0.8, 1.0), high = random.uniform(1.9, 2.3);
  Piece piece("window");
  add_frame(piece, width, low, high, 0.06, frame);
  piece.box({0.12, width + 0.1, 0.04}, {0.05, 0, low}, frame);
  piece.box({0.01, width, high - low}, {0.005, 0, (low + high) / 2}, random_print(random));
  const int bars = 1 + static_cast<int>(width / 0.9);
  for (int i = 1; i < bars; ++i) {
    piece.box({0.05, 0.06, high - low}, {0.025, -width / 2 + width * i / bars, (low + high) / 2}, frame);
  }
  return piece.take();
}

world::Body door(RandomStream& random) {
  const world::Material look = random.uniform() < 0.5 ? random_paint(random) : random_wood(random);
  const double width = random.uniform(0.8, 1.0), height = random.uniform(1.98, 2.1);
  Piece piece("door");
  piece.box({0.03, width, height}, {0.015, 0, height / 2}, look);
  add_frame(piece, width + 0.06, 0, height + 0.03, random.uniform(0.03, 0.06), look);
  const double side = random.uniform() < 0.5 ? 1 : -1;
  piece.box({0.05, 0.12, 0.02}, {0.055, side * (width / 2 - 0.1), 1.05}, random_dark(random));
  if (random.uniform() < 0.5) {
    for (const double z : {0.55, 1.5}) piece.box({0.01, width - 0.3, 0.7}, {0.032, 0, z}, look);
  }
  return piece.take();
}

world::Body curtain(RandomStream& random) {
  const world::Material cloth = random_fabric(random);
  const double width = random.uniform(0.4, 1.0), low = random.uniform(0.02, 0.1), high = random.uniform(2.1, 2.3);
  Piece piece("curtain");
  for (double y = -width / 2; y < width / 2; y += 0.09) {
    piece.cylinder(0.045, high - low, {0.09 + 0.01 * random.normal(), y, (low + high) / 2}, cloth);
  }
  return piece.take();
}

constexpr std::array<FurnitureKind, 9> kDecoration{{{"lamp_floor", Stand::kAnywhere, 0.8, floor_lamp},
                                                    {"plant_tall", Stand::kAnywhere, 1.2, tall_plant},
                                                    {"bin", Stand::kAnywhere, 1.2, bin},
                                                    {"coat_rack", Stand::kOnWall, 0.5, coat_rack},
                                                    {"mirror", Stand::kOnWall, 0.5, mirror},
                                                    {"picture", Stand::kOnWall, 3.0, picture},
                                                    {"window", Stand::kOnWall, 2.5, window},
                                                    {"door", Stand::kOnWall, 1.8, door},
                                                    {"curtain", Stand::kOnWall, 0.7, curtain}}};

}  // namespace

std::span<const FurnitureKind> decoration() { return kDecoration; }

}  // namespace amiss::training
