// Permanent small things: all of them otherprop.
#include <array>
#include <numbers>

#include "training/furniture.hpp"
#include "training/looks.hpp"
#include "training/piece.hpp"

namespace amiss::training {

namespace {

using Eigen::Vector3d;

world::Body screen(RandomStream& random) {
  const world::Material dark = random_dark(random);
  const double width = random.uniform(0.4, 0.75), height = width * 0.58, z = height / 2 + random.uniform(0.06, 0.16);
  Piece piece("monitor");
  piece.box({0.18, 0.24, 0.015}, {0, 0, 0.008}, dark).box({0.04, 0.06, z}, {-0.03, 0, z / 2}, dark);
  piece.box({0.035, width, height}, {0, 0, z}, dark);
  piece.box({0.002, width - 0.04, height - 0.04}, {0.019, 0, z}, random_print(random));
  return piece.take();
}

world::Body keyboard(RandomStream& random) {
  Piece piece("keyboard");
  const world::Material look = random.uniform() < 0.6 ? random_dark(random) : random_paint(random);
  piece.box({random.uniform(0.11, 0.17), random.uniform(0.28, 0.46), random.uniform(0.015, 0.03)}, {0, 0, 0.01}, look);
  return piece.take();
}

world::Body laptop(RandomStream& random) {
  const world::Material look = random.uniform() < 0.5 ? random_dark(random) : random_paint(random);
  const double width = random.uniform(0.3, 0.38), lean = random.uniform(0.1, 0.5);
  Piece piece("laptop");
  piece.box({0.23, width, 0.02}, {0, 0, 0.01}, look);
  piece.box({0.012, width, 0.22}, {-0.115 - 0.11 * std::sin(lean), 0, 0.02 + 0.11 * std::cos(lean)}, look,
            turned(-lean, Vector3d::UnitY()));
  return piece.take();
}

world::Body lamp(RandomStream& random) {
  const double height = random.uniform(0.25, 0.45), radius = random.uniform(0.07, 0.14);
  Piece piece("lamp_table");
  piece.cylinder(radius * 0.7, 0.03, {0, 0, 0.015}, random_board(random));
  piece.cylinder(0.015, height, {0, 0, height / 2}, random_dark(random));
  piece.cylinder(radius, height * 0.5, {0, 0, height * 0.8}, random_paint(random));
  return piece.take();
}

world::Body small_plant(RandomStream& random) {
  Piece piece("plant_small");
  const double pot = random.uniform(0.08, 0.16);
  piece.cylinder(random.uniform(0.05, 0.1), pot, {0, 0, pot / 2}, random_plastic(random));
  const world::Material leaf = random_leaf(random);
  const double reach = random.uniform(0.08, 0.2);
  for (int i = 0; i < 14; ++i) {
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    piece.box({reach, reach * 0.35, 0.005},
              {reach * 0.5 * std::cos(angle), reach * 0.5 * std::sin(angle), pot + random.uniform(0.02, reach)}, leaf,
              turned(angle, Vector3d::UnitZ()) * turned(random.uniform(-1.0, 0.2), Vector3d::UnitY()));
  }
  return piece.take();
}

world::Body book_pile(RandomStream& random) {
  Piece piece("book_pile");
  double z = 0;
  const int books = 1 + static_cast<int>(random.below(5));
  for (int i = 0; i < books; ++i) {
    const double thick = random.uniform(0.015, 0.045);
    piece.box({random.uniform(0.14, 0.22), random.uniform(0.19, 0.3), thick}, {0, 0, z + thick / 2},
              random_print(random), turned(random.uniform(-0.3, 0.3), Vector3d::UnitZ()));
    z += thick;
  }
  return piece.take();
}

world::Body cushion(RandomStream& random) {
  Piece piece("cushion");
  const double edge = random.uniform(0.35, 0.48), lean = random.uniform(0.1, 0.9);
  const world::Material cover = random_fabric(random);
  const double z = edge / 2 * std::cos(lean) + 0.05 * std::sin(lean);
  piece.box({0.08, edge, edge}, {0, 0, z}, cover, turned(-lean, Vector3d::UnitY()));
  piece.box({0.13, edge * 0.75, edge * 0.75}, {0, 0, z}, cover, turned(-lean, Vector3d::UnitY()));
  return piece.take();
}

/// Machines, pots, boxes, jars: one body, and some smaller ones in it, on it or beside it.
world::Body thing(RandomStream& random) {
  const double size = random.uniform() < 0.6 ? random.uniform(0.05, 0.16) : random.uniform(0.14, 0.32);
  const Vector3d edges(size * random.uniform(0.5, 1.3), size * random.uniform(0.5, 1.3),
                       size * random.uniform(0.4, 1.7));
  const world::Material look = random.uniform() < 0.3 ? random_print(random) : random_plastic(random);
  Piece piece("vase");
  if (random.uniform() < 0.5) {
    piece.box(edges, {0, 0, edges.z() / 2}, look);
  } else {
    piece.cylinder(edges.x() / 2, edges.z(), {0, 0, edges.z() / 2}, look);
  }
  const int parts = static_cast<int>(random.below(4));
  for (int i = 0; i < parts; ++i) {
    const Vector3d at(random.uniform(-0.5, 0.5) * edges.x(), random.uniform(-0.5, 0.5) * edges.y(),
                      edges.z() * random.uniform(0.6, 1.15));
    const world::Material other = random.uniform() < 0.5 ? look : random_plastic(random);
    const double part = size * random.uniform(0.2, 0.5), kind = random.uniform();
    if (kind < 0.4) {
      piece.box({part, part * random.uniform(0.3, 2.0), part}, at, other);
    } else if (kind < 0.8) {
      piece.cylinder(part / 2, part * random.uniform(0.5, 1.5), at, other);
    } else {
      piece.ball(part / 2, at, other);
    }
  }
  return piece.take();
}

world::Body utensils(RandomStream& random) {
  const double height = random.uniform(0.08, 0.16), radius = random.uniform(0.035, 0.07);
  Piece piece("utensils");
  piece.cylinder(radius, height, {0, 0, height / 2}, random_plastic(random));
  for (int i = 0; i < 5; ++i) {
    const double length = height * random.uniform(1.3, 2.2), angle = random.uniform(0, 2 * std::numbers::pi);
    piece.cylinder(0.006, length, {radius / 2 * std::cos(angle), radius / 2 * std::sin(angle), length / 2},
                   random_plastic(random), turned(0.15, Vector3d(-std::sin(angle), std::cos(angle), 0)));
  }
  return piece.take();
}

world::Body trays(RandomStream& random) {
  const world::Material look = random_plastic(random);
  const int levels = 2 + static_cast<int>(random.below(3));
  Piece piece("paper_tray");
  for (int i = 0; i < levels; ++i) piece.box({0.24, 0.32, 0.008}, {0, 0, 0.01 + 0.06 * i}, look);
  for (const double side : {-1.0, 1.0}) piece.box({0.2, 0.01, 0.06 * levels}, {0, side * 0.155, 0.03 * levels}, look);
  return piece.take();
}

constexpr std::array<FurnitureKind, 10> kProps{{{"monitor", Stand::kOnFurniture, 1.2, screen},
                                                {"keyboard", Stand::kOnFurniture, 1.0, keyboard},
                                                {"laptop", Stand::kOnFurniture, 0.7, laptop},
                                                {"lamp_table", Stand::kOnFurniture, 0.8, lamp},
                                                {"plant_small", Stand::kOnFurniture, 0.8, small_plant},
                                                {"book_pile", Stand::kOnFurniture, 0.8, book_pile},
                                                {"cushion", Stand::kOnFurniture, 1.0, cushion},
                                                {"vase", Stand::kOnFurniture, 3.0, thing},
                                                {"utensils", Stand::kOnFurniture, 0.5, utensils},
                                                {"paper_tray", Stand::kOnFurniture, 0.4, trays}}};

}  // namespace

std::span<const FurnitureKind> props() { return kProps; }

}  // namespace amiss::training
