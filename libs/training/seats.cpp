// Chairs, sofas, beds and tables.
#include <array>
#include <numbers>

#include "training/furniture.hpp"
#include "training/looks.hpp"
#include "training/piece.hpp"

namespace amiss::training {

namespace {

using Eigen::Vector3d;

void add_legs(Piece& piece, const Vector3d& half, double height_m, double thickness_m, const world::Material& look) {
  for (const double x : {-half.x(), half.x()}) {
    for (const double y : {-half.y(), half.y()}) {
      piece.box({thickness_m, thickness_m, height_m}, {x, y, height_m / 2}, look);
    }
  }
}

world::Body dining_chair(RandomStream& random) {
  const world::Material frame = random_board(random), seat = random.uniform() < 0.5 ? random_fabric(random) : frame;
  const double width = random.uniform(0.38, 0.5), depth = random.uniform(0.38, 0.48),
               height = random.uniform(0.42, 0.5);
  const double back = random.uniform(0.8, 1.0), lean = random.uniform(0.0, 0.2), leg = random.uniform(0.025, 0.05);
  Piece piece("chair");
  add_legs(piece, {depth / 2 - 0.03, width / 2 - 0.03, 0}, height - 0.03, leg, frame);
  piece.box({depth, width, random.uniform(0.02, 0.07)}, {0, 0, height - 0.02}, seat);
  const auto tilt = turned(-lean, Vector3d::UnitY());
  const double rise = back - height, x = -depth / 2 - rise / 2 * lean + 0.02;
  for (const double y : {-width / 2 + 0.02, width / 2 - 0.02}) {
    piece.box({leg, leg, rise}, {x, y, height + rise / 2}, frame, tilt);
  }
  const int slats = 1 + static_cast<int>(random.below(4));
  for (int i = 0; i < slats; ++i) {
    const double z = back - (i + 0.5) * rise / (slats + 0.5), up = z - height - rise / 2;
    piece.box({0.02, width, slats == 1 ? rise * 0.7 : 0.06}, {x - lean * up, 0, z}, slats == 1 ? seat : frame, tilt);
  }
  return piece.take();
}

world::Body office_chair(RandomStream& random) {
  const world::Material dark = random_dark(random), cover = random_fabric(random);
  const double height = random.uniform(0.44, 0.54), width = random.uniform(0.44, 0.54);
  Piece piece("chair");
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * std::numbers::pi * i / 5;
    piece.box({0.28, 0.04, 0.03}, {0.14 * std::cos(angle), 0.14 * std::sin(angle), 0.07}, dark,
              turned(angle, Vector3d::UnitZ()));
    piece.ball(0.03, {0.27 * std::cos(angle), 0.27 * std::sin(angle), 0.03}, dark);
  }
  piece.cylinder(0.03, height - 0.1, {0, 0, height / 2}, dark);
  piece.box({width, width, 0.08}, {0, 0, height}, cover);
  const double rise = random.uniform(0.4, 0.65);
  piece.box({0.06, width * 0.9, rise}, {-width / 2 - 0.03, 0, height + 0.08 + rise / 2}, cover,
            turned(-random.uniform(0, 0.2), Vector3d::UnitY()));
  if (random.uniform() < 0.6) {
    for (const double y : {-width / 2 - 0.03, width / 2 + 0.03}) {
      piece.box({0.04, 0.03, 0.2}, {0, y, height + 0.1}, dark).box({0.26, 0.06, 0.03}, {0, y, height + 0.21}, dark);
    }
  }
  return piece.take();
}

world::Body stool(RandomStream& random) {
  const world::Material wood = random_board(random);
  const double radius = random.uniform(0.15, 0.21), height = random.uniform(0.42, 0.68);
  Piece piece("stool");
  piece.cylinder(radius, random.uniform(0.03, 0.08), {0, 0, height - 0.02}, wood);
  const int legs = 3 + static_cast<int>(random.below(2));
  for (int i = 0; i < legs; ++i) {
    const double angle = 2 * std::numbers::pi * i / legs;
    piece.cylinder(0.018, height - 0.03, {radius * 0.75 * std::cos(angle), radius * 0.75 * std::sin(angle), height / 2},
                   wood);
  }
  return piece.take();
}

world::Body upholstered(RandomStream& random, const char* name, double width) {
  const world::Material cover = random_fabric(random);
  const double depth = random.uniform(0.78, 0.98), seat = random.uniform(0.38, 0.48), back = random.uniform(0.7, 0.95);
  const double arm = random.uniform(0.1, 0.24), arm_height = random.uniform(0.52, 0.68);
  Piece piece(name);
  piece.box({depth, width, seat - 0.17}, {0, 0, (seat - 0.17) / 2 + 0.05}, cover);
  piece.box({0.24, width - 2 * arm, back - seat}, {-depth / 2 + 0.14, 0, (back + seat) / 2}, cover,
            turned(-0.12, Vector3d::UnitY()));
  for (const double side : {-1.0, 1.0}) {
    piece.box({depth, arm, arm_height - 0.05}, {0, side * (width - arm) / 2, arm_height / 2 + 0.02}, cover);
  }
  const int seats = std::max(1, static_cast<int>(width / 0.7));
  const double each = (width - 2 * arm) / seats;
  for (int i = 0; i < seats; ++i) {
    piece.box({depth - 0.22, each - 0.012, 0.15}, {0.1, -(width - 2 * arm) / 2 + each * (i + 0.5), seat - 0.075},
              cover);
  }
  return piece.take();
}

world::Body sofa(RandomStream& random) { return upholstered(random, "sofa", random.uniform(1.4, 2.4)); }
world::Body armchair(RandomStream& random) { return upholstered(random, "armchair", random.uniform(0.75, 1.0)); }

world::Body bed(RandomStream& random) {
  const world::Material wood = random_board(random), sheet = random_fabric(random), pillow = random_paint(random);
  const double width = random.uniform(0.9, 1.8), length = random.uniform(1.95, 2.1), height = random.uniform(0.42, 0.6);
  Piece piece("bed");
  piece.box({length, width, 0.22}, {0, 0, height - 0.27}, wood);
  piece.box({length - 0.04, width - 0.04, 0.18}, {0, 0, height - 0.09}, sheet);
  const double head = random.uniform(0.3, 0.6);
  piece.box({0.05, width, height + head}, {-length / 2, 0, (height + head) / 2}, wood);
  const int pillows = width > 1.3 ? 2 : 1;
  for (int i = 0; i < pillows; ++i) {
    piece.box({0.4, 0.6, 0.12}, {-length / 2 + 0.3, (i - (pillows - 1) / 2.0) * 0.75, height + 0.05}, pillow);
  }
  piece.box({length * 0.6, width + 0.02, 0.06}, {length * 0.18, 0, height + 0.02}, random_fabric(random));
  return piece.take();
}

world::Body table(RandomStream& random) {
  const world::Material wood = random_board(random);
  const bool low = random.uniform() < 0.4;
  const double height = low ? random.uniform(0.32, 0.52) : random.uniform(0.68, 0.8);
  const double width = low ? random.uniform(0.6, 1.3) : random.uniform(0.7, 2.0);
  const double depth = std::min(width, random.uniform(low ? 0.45 : 0.6, 1.0)), thickness = random.uniform(0.02, 0.05);
  Piece piece("table");
  if (random.uniform() < 0.25) {
    const double radius = low ? random.uniform(0.25, 0.5) : random.uniform(0.35, 0.6);
    piece.cylinder(radius, thickness, {0, 0, height - thickness / 2}, wood);
    piece.cylinder(random.uniform(0.03, 0.07), height, {0, 0, height / 2 - thickness}, wood);
    piece.cylinder(radius * 0.6, 0.03, {0, 0, 0.015}, wood);
    return piece.take();
  }
  piece.box({depth, width, thickness}, {0, 0, height - thickness / 2}, wood);
  if (random.uniform() < 0.3) {
    for (const double side : {-1.0, 1.0}) {
      piece.box({depth * 0.85, 0.05, height - thickness}, {0, side * (width / 2 - 0.15), (height - thickness) / 2},
                wood);
    }
  } else {
    add_legs(piece, {depth / 2 - 0.05, width / 2 - 0.05, 0}, height - thickness, random.uniform(0.03, 0.08), wood);
  }
  if (random.uniform() < 0.3) piece.box({depth * 0.8, width * 0.8, 0.02}, {0, 0, height * 0.3}, wood);
  return piece.take();
}

world::Body desk(RandomStream& random) {
  const world::Material wood = random_board(random), front = random_board(random);
  const double height = random.uniform(0.70, 0.78), width = random.uniform(1.1, 1.9),
               depth = random.uniform(0.55, 0.85);
  Piece piece("desk");
  piece.box({depth, width, 0.03}, {0, 0, height - 0.015}, wood);
  const double block = random.uniform(0.35, 0.48), side = random.uniform() < 0.5 ? 1 : -1;
  piece.box({depth - 0.08, block, height - 0.08}, {0, side * (width - block) / 2, height / 2 - 0.01}, front);
  if (random.uniform() < 0.5) {
    piece.box({depth - 0.05, 0.03, height - 0.03}, {0, -side * (width / 2 - 0.03), height / 2 - 0.02}, wood);
  } else {
    for (const double x : {-depth / 2 + 0.05, depth / 2 - 0.05}) {
      piece.box({0.05, 0.05, height - 0.03}, {x, -side * (width / 2 - 0.05), height / 2 - 0.02}, wood);
    }
  }
  if (random.uniform() < 0.5) piece.box({0.02, width * 0.95, 0.35}, {-depth / 2 + 0.1, 0, height - 0.22}, wood);
  return piece.take();
}

constexpr std::array<FurnitureKind, 8> kSeats{{{"chair", Stand::kAnywhere, 3.0, dining_chair},
                                               {"chair", Stand::kAnywhere, 2.0, office_chair},
                                               {"stool", Stand::kAnywhere, 1.0, stool},
                                               {"sofa", Stand::kAtWall, 2.0, sofa},
                                               {"armchair", Stand::kAnywhere, 1.5, armchair},
                                               {"bed", Stand::kAtWall, 0.5, bed},
                                               {"table", Stand::kAnywhere, 3.0, table},
                                               {"desk", Stand::kAtWall, 2.5, desk}}};

}  // namespace

std::span<const FurnitureKind> seats() { return kSeats; }

}  // namespace amiss::training
