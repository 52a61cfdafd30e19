// What one keeps things in, and what stands in kitchens and bathrooms.
#include <array>

#include "training/furniture.hpp"
#include "training/looks.hpp"
#include "training/piece.hpp"

namespace amiss::training {

namespace {

using Eigen::Vector3d;

/// Doors or drawers on a front at x, with handles: columns x rows of them.
void add_fronts(Piece& piece, const Vector3d& size, double low_m, const world::Material& look, RandomStream& random) {
  const int columns = 1 + static_cast<int>(size.y() / random.uniform(0.4, 0.7));
  const int rows = 1 + static_cast<int>((size.z() - low_m) / random.uniform(0.22, 0.9));
  const double width = size.y() / columns, height = (size.z() - low_m - 0.03) / rows;
  const world::Material handle = random_dark(random);
  const bool handles = random.uniform() < 0.7;
  for (int c = 0; c < columns; ++c) {
    for (int r = 0; r < rows; ++r) {
      const double y = -size.y() / 2 + width * (c + 0.5), z = low_m + height * (r + 0.5);
      piece.box({0.018, width - 0.008, height - 0.008}, {size.x() / 2 + 0.005, y, z}, look);
      if (handles)
        piece.box({0.02, std::min(0.12, width / 2), 0.015}, {size.x() / 2 + 0.022, y, z + height / 3}, handle);
    }
  }
}

world::Body closed(RandomStream& random, const char* name, const Vector3d& size) {
  const world::Material body = random_board(random), front = random.uniform() < 0.5 ? body : random_board(random);
  Piece piece(name);
  const double legs = random.uniform() < 0.5 ? random.uniform(0.05, 0.15) : 0.0;
  piece.box({size.x(), size.y(), size.z() - legs}, {0, 0, (size.z() + legs) / 2}, body);
  if (legs > 0) {
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) {
        piece.box({0.04, 0.04, legs}, {x * (size.x() / 2 - 0.04), y * (size.y() / 2 - 0.04), legs / 2}, body);
      }
    }
  }
  add_fronts(piece, size, legs + 0.02, front, random);
  return piece.take();
}

world::Body cabinet(RandomStream& random) {
  return closed(random, "cabinet", {random.uniform(0.3, 0.6), random.uniform(0.4, 1.8), random.uniform(0.45, 0.9)});
}
world::Body cupboard(RandomStream& random) {
  return closed(random, "cupboard", {random.uniform(0.35, 0.6), random.uniform(0.6, 1.5), random.uniform(1.1, 2.2)});
}
world::Body tv_board(RandomStream& random) {
  world::Body body =
      closed(random, "tv_board", {random.uniform(0.35, 0.5), random.uniform(1.2, 2.0), random.uniform(0.4, 0.6)});
  return body;
}
world::Body washing_machine(RandomStream& random) {
  const world::Material white = random_paint(random);
  Piece piece("washing_machine");
  piece.box({0.6, 0.6, 0.85}, {0, 0, 0.425}, white);
  piece.cylinder(0.17, 0.03, {0.3, 0, 0.45}, random_dark(random), turned(radians(90), Vector3d::UnitY()));
  return piece.take();
}
world::Body fridge(RandomStream& random) {
  const world::Material look = random.uniform() < 0.6 ? random_paint(random) : random_plastic(random);
  const Vector3d size(random.uniform(0.55, 0.7), random.uniform(0.55, 0.75), random.uniform(1.3, 2.0));
  const double split = random.uniform(0.4, 0.9);
  Piece piece("fridge");
  piece.box(size, {0, 0, size.z() / 2}, look);
  piece.box({0.03, size.y(), split - 0.03}, {size.x() / 2, 0, split / 2 + 0.02}, look);
  piece.box({0.03, size.y(), size.z() - split - 0.01}, {size.x() / 2, 0, (size.z() + split) / 2}, look);
  for (const double z : {split - 0.2, split + 0.2}) {
    piece.box({0.03, 0.03, 0.3}, {size.x() / 2 + 0.04, size.y() / 2 - 0.06, z}, random_dark(random));
  }
  return piece.take();
}

/// Rows of books or boxes that stand on a board of the given width.
void add_content(Piece& piece, double depth, double width, double z, double room_m, RandomStream& random) {
  double y = -width / 2 + random.uniform(0.0, 0.1);
  while (y < width / 2 - 0.12) {
    const double length = std::min(random.uniform(0.08, 0.4), width / 2 - y - 0.01);
    const double height = room_m * random.uniform(0.45, 0.85), deep = depth * random.uniform(0.5, 0.85);
    if (random.uniform() < 0.7)
      piece.box({deep, length, height}, {0, y + length / 2, z + height / 2}, random_print(random));
    y += length + random.uniform(0.0, 0.15);
  }
}

world::Body bookcase(RandomStream& random) {
  const bool posts = random.uniform() < 0.4;
  const world::Material wood = random_board(random), frame = posts ? random_dark(random) : wood;
  const double depth = random.uniform(0.26, 0.45), width = random.uniform(0.6, 1.2), height = random.uniform(0.9, 2.1);
  Piece piece(posts ? "shelf" : "bookcase");
  for (const double side : {-1.0, 1.0}) {
    if (posts) {
      for (const double x : {-1.0, 1.0}) {
        piece.box({0.03, 0.03, height}, {x * (depth / 2 - 0.015), side * (width / 2 - 0.015), height / 2}, frame);
      }
    } else {
      piece.box({depth, 0.022, height}, {0, side * width / 2, height / 2}, wood);
    }
  }
  if (!posts && random.uniform() < 0.8) piece.box({0.01, width, height}, {-depth / 2, 0, height / 2}, wood);
  const int boards = std::max(2, static_cast<int>(height / random.uniform(0.3, 0.45)));
  const double step = (height - 0.1) / boards, full = random.uniform(0, 1);
  for (int i = 0; i <= boards; ++i) {
    const double z = 0.08 + step * i;
    piece.box({depth, width - 0.02, 0.022}, {0, 0, z}, wood);
    if (i < boards && random.uniform() < full) add_content(piece, depth, width - 0.06, z + 0.011, step - 0.03, random);
  }
  return piece.take();
}

void add_all(world::Body& body, const world::Body& other) {
  body.visuals.insert(body.visuals.end(), other.visuals.begin(), other.visuals.end());
  body.collisions.insert(body.collisions.end(), other.collisions.begin(), other.collisions.end());
}

/// Closed below, a top board over it, perhaps with a hob in it.
world::Body counter(RandomStream& random) {
  const world::Material top = random.uniform() < 0.5 ? random_board(random) : random_plastic(random);
  const Vector3d size(random.uniform(0.55, 0.65), random.uniform(1.4, 3.2), random.uniform(0.80, 0.90));
  world::Body body = closed(random, "counter", size);
  Piece piece("counter");
  piece.box({size.x() + 0.03, size.y(), 0.04}, {0.01, 0, size.z() + 0.02}, top);
  if (random.uniform() < 0.5) {
    const double y = (random.uniform() - 0.5) * (size.y() - 0.7);
    piece.box({0.5, 0.56, 0.008}, {0, y, size.z() + 0.043}, random_dark(random));
  }
  if (random.uniform() < 0.5) {
    piece.box({0.015, size.y(), random.uniform(0.3, 0.6)}, {-size.x() / 2 + 0.008, 0, size.z() + 0.3}, top);
  }
  add_all(body, piece.take());
  return body;
}

/// A wall unit hangs between 1.4 and 2.2 m.
world::Body wall_unit(RandomStream& random) {
  const world::Material look = random_board(random);
  const Vector3d size(random.uniform(0.3, 0.4), random.uniform(0.8, 2.6), random.uniform(0.5, 0.8));
  Piece piece("kitchen_wall_unit");
  const int doors = 1 + static_cast<int>(size.y() / 0.55);
  const double low = random.uniform(1.35, 1.5), width = size.y() / doors;
  piece.box(size, {size.x() / 2, 0, low + size.z() / 2}, look);
  for (int i = 0; i < doors; ++i) {
    piece.box({0.02, width - 0.01, size.z() - 0.01},
              {size.x() + 0.005, -size.y() / 2 + width * (i + 0.5), low + size.z() / 2}, look);
  }
  return piece.take();
}

constexpr std::array<FurnitureKind, 8> kStorage{{{"cabinet", Stand::kAtWall, 3.0, cabinet},
                                                 {"cupboard", Stand::kAtWall, 1.5, cupboard},
                                                 {"tv_board", Stand::kAtWall, 1.0, tv_board},
                                                 {"washing_machine", Stand::kAtWall, 0.4, washing_machine},
                                                 {"fridge", Stand::kAtWall, 2.0, fridge},
                                                 {"bookcase", Stand::kAtWall, 3.5, bookcase},
                                                 {"counter", Stand::kAtWall, 2.5, counter},
                                                 {"kitchen_wall_unit", Stand::kOnWall, 0.6, wall_unit}}};

}  // namespace

std::span<const FurnitureKind> storage() { return kStorage; }

world::Body random_sink(RandomStream& random) {
  const world::Material steel = random_paint(random);
  const double depth = random.uniform(0.38, 0.48), width = random.uniform(0.4, 0.8), rim = random.uniform(0.03, 0.06);
  const double rise = random.uniform(0.01, 0.14), x = random.uniform(0.15, 0.25);
  Piece piece("kitchen_sink");
  piece.box({depth, width, 0.006}, {0, 0, 0.003}, steel);
  for (const double side : {-1.0, 1.0}) {
    piece.box({depth, rim, rise}, {0, side * (width - rim) / 2, rise / 2}, steel);
    piece.box({rim, width, rise}, {side * (depth - rim) / 2, 0, rise / 2}, steel);
  }
  const double tap = random.uniform(0.15, 0.35);
  piece.cylinder(0.015, tap, {-x, 0, rise + tap / 2}, steel);
  piece.box({0.18, 0.02, 0.02}, {-x + 0.08, 0, rise + tap}, steel);
  return piece.take();
}

}  // namespace amiss::training
