#include "training/room.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "sim/supports.hpp"
#include "training/looks.hpp"
#include "training/piece.hpp"
#include "world/bounds.hpp"

namespace amiss::training {

namespace {

using Eigen::AlignedBox3d, Eigen::Vector2d, Eigen::Vector3d;

constexpr double kWall_m = 2.5, kHead_m = 1.3;

Eigen::Isometry3d upright(double x, double y, double yaw_rad) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translate(Vector3d(x, y, 0)).rotate(Eigen::AngleAxisd(yaw_rad, Vector3d::UnitZ()));
  return T;
}

const FurnitureKind& chosen(std::span<const FurnitureKind> kinds, Stand stand, RandomStream& random) {
  double sum = 0;
  for (const FurnitureKind& kind : kinds) sum += kind.stand == stand ? kind.often : 0.0;
  double at = random.uniform() * sum;
  const FurnitureKind* last = nullptr;
  for (const FurnitureKind& kind : kinds) {
    if (kind.stand != stand) continue;
    last = &kind;
    if ((at -= kind.often) < 0) break;
  }
  return *last;
}

/// All kinds of one stand, with their weights.
std::vector<FurnitureKind> kinds_of(Stand stand) {
  std::vector<FurnitureKind> kinds;
  for (const auto table : {seats(), storage(), decoration(), props()}) {
    for (const FurnitureKind& kind : table) {
      if (kind.stand == stand) kinds.push_back(kind);
    }
  }
  return kinds;
}

class Furnisher {
 public:
  Furnisher(const world::Catalogue& catalogue, RandomStream& random) : catalogue_(catalogue), random_(random) {
    room_.size_m = {random.uniform(3.0, 7.0), random.uniform(3.0, 6.0)};
    room_.world.name = "training";
  }

  TrainingRoom furnish() {
    build();
    hang(2 + static_cast<int>(random_.below(6)));
    line_up(4 + static_cast<int>(random_.below(8)));
    spread(3 + static_cast<int>(random_.below(6)));
    const std::vector<sim::Support> supports = sim::find_supports(room_.world);
    for (const sim::Support& support : supports) cover(support);
    const auto on_floor = 2 + random_.below(7);
    for (std::uint64_t i = 0; i < on_floor; ++i) drop();
    return std::move(room_);
  }

 private:
  void build() {
    const double x = room_.size_m.x(), y = room_.size_m.y();
    const world::Material paint = random_paint(random_);
    const world::Material ground = random_.uniform() < 0.7 ? random_wood(random_) : random_fabric(random_);
    const auto part = [&](const char* name, const Vector3d& size, const Vector3d& middle, const world::Material& look) {
      room_.world.bodies.push_back(Piece(name).box(size, middle, look).take());
    };
    part("floor", {x + 0.4, y + 0.4, 0.1}, {x / 2, y / 2, -0.05}, ground);
    part("wall_west", {0.1, y + 0.2, kWall_m}, {-0.05, y / 2, kWall_m / 2}, paint);
    part("wall_east", {0.1, y + 0.2, kWall_m}, {x + 0.05, y / 2, kWall_m / 2}, paint);
    part("wall_south", {x, 0.1, kWall_m}, {x / 2, -0.05, kWall_m / 2}, paint);
    part("wall_north", {x, 0.1, kWall_m}, {x / 2, y + 0.05, kWall_m / 2}, paint);
    if (random_.uniform() < 0.5) {
      part("rug", {random_.uniform(0.8, x - 1), random_.uniform(0.8, y - 1), 0.004}, {x / 2, y / 2, 0.002},
           random_.uniform() < 0.5 ? random_fabric(random_) : random_print(random_));
    }
    room_.world.lights.push_back({});
    structure_ = room_.world.bodies.size();
  }

  /// A pose with the back at a wall, `gap` before it, the middle at `along` of the wall's length.
  [[nodiscard]] Eigen::Isometry3d at_wall(double back_m, double width_m) {
    const std::uint64_t wall = random_.below(4);
    const double length = wall < 2 ? room_.size_m.y() : room_.size_m.x();
    const double along = random_.uniform(width_m / 2, std::max(length - width_m / 2, width_m / 2 + 0.01));
    switch (wall) {
      case 0:
        return upright(back_m, along, 0);
      case 1:
        return upright(room_.size_m.x() - back_m, along, std::numbers::pi);
      case 2:
        return upright(along, back_m, std::numbers::pi / 2);
      default:
        return upright(along, room_.size_m.y() - back_m, -std::numbers::pi / 2);
    }
  }

  /// Its shapes as boxes in the world.
  static std::vector<AlignedBox3d> boxes_of(const world::Body& body, const Eigen::Isometry3d& T) {
    std::vector<AlignedBox3d> boxes;
    for (const world::Shape& shape : body.visuals)
      boxes.push_back(world::bounds(shape.geometry, T * shape.T_body_shape));
    return boxes;
  }
  [[nodiscard]] bool is_inside(const AlignedBox3d& box) const {
    return (box.min().head<2>().array() > -0.02).all() &&
           (box.max().head<2>().array() < room_.size_m.array() + 0.02).all();
  }
  [[nodiscard]] bool is_clear(const std::vector<AlignedBox3d>& boxes, double gap_m) const {
    for (const AlignedBox3d& box : boxes) {
      const AlignedBox3d grown(box.min().array() - gap_m, box.max().array() + gap_m);
      for (const AlignedBox3d& other : taken_) {
        if (grown.intersects(other)) return false;
      }
    }
    return true;
  }
  /// Puts a body there when nothing is in the way.
  bool put(world::Body body, const Eigen::Isometry3d& T, double gap_m) {
    const std::vector<AlignedBox3d> boxes = boxes_of(body, T);
    if (!std::all_of(boxes.begin(), boxes.end(), [&](const auto& b) { return is_inside(b); })) return false;
    if (!is_clear(boxes, gap_m)) return false;
    taken_.insert(taken_.end(), boxes.begin(), boxes.end());
    body.name += "_" + std::to_string(room_.world.bodies.size());
    body.pose.T = T;
    room_.world.bodies.push_back(std::move(body));
    return true;
  }

  void hang(int count) {
    const auto kinds = kinds_of(Stand::kOnWall);
    for (int i = 0; i < count; ++i) {
      const world::Body body = chosen(kinds, Stand::kOnWall, random_).make(random_);
      for (int tries = 0; tries < 5 && !put(body, at_wall(0.0, 1.0), 0.02); ++tries) continue;
    }
  }

  void line_up(int count) {
    const auto kinds = kinds_of(Stand::kAtWall);
    for (int i = 0; i < count; ++i) {
      const world::Body body = chosen(kinds, Stand::kAtWall, random_).make(random_);
      const AlignedBox3d box = world::bounds(body.visuals);
      const double back = -box.min().x() + random_.uniform(0.0, 0.06);
      bool stands = false;
      for (int tries = 0; tries < 8 && !stands; ++tries) {
        stands = put(body, at_wall(back, box.sizes().y() + 0.02), 0.01);
      }
      if (stands && body.name == "counter" && random_.uniform() < 0.7) let_in_sink(room_.world.bodies.size() - 1);
    }
  }
  /// Somewhere on the largest level top of a counter.
  void let_in_sink(std::size_t counter) {
    std::optional<sim::Support> board;
    for (const sim::Support& support : sim::find_supports(room_.world)) {
      if (support.body == counter && (!board || support.height_m() > board->height_m()) && support.area_m2() > 0.6) {
        board = support;
      }
    }
    if (!board) return;
    Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
    turn.linear() = room_.world.bodies[counter].pose.T.linear();
    const Eigen::Vector3d along = turn.linear() * Vector3d(0.0, random_.uniform(-0.7, 0.7), 0.0);
    lay(random_sink(random_), turn, board->T_world_top.translation() + along);
  }

  void spread(int count) {
    const auto kinds = kinds_of(Stand::kAnywhere);
    for (int i = 0; i < count; ++i) {
      const FurnitureKind& kind = chosen(kinds, Stand::kAnywhere, random_);
      const world::Body body = kind.make(random_);
      bool stands = false;
      for (int tries = 0; tries < 8 && !stands; ++tries) {
        const double yaw = random_.uniform() < 0.6 ? std::numbers::pi / 2 * static_cast<double>(random_.below(4))
                                                   : random_.uniform(0, 2 * std::numbers::pi);
        stands = put(
            body,
            upright(random_.uniform(0.3, room_.size_m.x() - 0.3), random_.uniform(0.3, room_.size_m.y() - 0.3), yaw),
            0.03);
      }
      if (stands && kind.name == "table") seat(room_.world.bodies.back());
    }
  }

  /// Chairs at the sides of a table, partly under it.
  void seat(const world::Body& table) {
    const Eigen::Isometry3d T = table.pose.T;
    const Vector2d half = world::bounds(table.visuals).sizes().head<2>() / 2;
    if (world::bounds(table.visuals).max().z() < 0.6) return;
    for (int side = 0; side < 4; ++side) {
      if (random_.uniform() < 0.4) continue;
      const double yaw = std::numbers::pi / 2 * side;
      const double out = (side % 2 == 0 ? half.x() : half.y()) + random_.uniform(-0.15, 0.3);
      const Eigen::Isometry3d beside = upright(-out * std::cos(yaw), -out * std::sin(yaw), yaw);
      put(seats()[random_.below(2)].make(random_), T * beside, -0.04);
    }
  }

  /// How an object lies: upright, or tipped over, turned about the vertical.
  [[nodiscard]] Eigen::Isometry3d attitude() {
    Eigen::Isometry3d T = upright(0, 0, random_.uniform(0, 2 * std::numbers::pi));
    const double tipped = random_.uniform();
    if (tipped < 0.2) T.rotate(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX()));
    if (tipped > 0.8) T.rotate(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitY()));
    return T;
  }
  bool lay(world::Body body, Eigen::Isometry3d T, const Vector3d& at) {
    AlignedBox3d box;
    for (const AlignedBox3d& b : boxes_of(body, T)) box.extend(b);
    T.pretranslate(at - Vector3d(box.center().x(), box.center().y(), box.min().z() - 0.001));
    return put(std::move(body), T, -0.004);
  }
  [[nodiscard]] world::Body object() {
    world::Body body = catalogue_.entries[random_.below(catalogue_.entries.size())].body;
    body.name = "storage_box_" + body.name;
    body.is_static = true;
    return body;
  }
  [[nodiscard]] world::Body prop(double yaw_rad, Eigen::Isometry3d& T) {
    T = upright(0, 0, yaw_rad);
    const auto kinds = props();
    return chosen(kinds, Stand::kOnFurniture, random_).make(random_);
  }

  void cover(const sim::Support& support) {
    if (support.body < structure_) return;
    const double density = random_.uniform(0.0, 9.0);
    const int count = static_cast<int>(std::ceil(density * support.area_m2() - random_.uniform()));
    for (int i = 0; i < count; ++i) {
      const Vector3d at = support.T_world_top * Vector3d(random_.uniform(-0.9, 0.9) * support.half_m.x(),
                                                         random_.uniform(-0.9, 0.9) * support.half_m.y(), 0.0);
      if (!support.is_over(at.head<2>(), 0.02)) continue;
      if (random_.uniform() < 0.5 && !catalogue_.entries.empty()) {
        room_.objects += lay(object(), attitude(), at);
      } else {
        Eigen::Isometry3d T;
        const world::Body body = prop(random_.uniform(0, 2 * std::numbers::pi), T);
        lay(body, T, at);
      }
    }
  }

  void drop() {
    const Vector3d at(random_.uniform(0.1, room_.size_m.x() - 0.1), random_.uniform(0.1, room_.size_m.y() - 0.1), 0.0);
    if (!catalogue_.entries.empty()) room_.objects += lay(object(), attitude(), at);
  }

  const world::Catalogue& catalogue_;
  RandomStream& random_;
  TrainingRoom room_;
  std::size_t structure_ = 0;  // the first bodies: walls and floor
  std::vector<AlignedBox3d> taken_;
};

}  // namespace

bool TrainingRoom::is_free(const Eigen::Vector2d& p, double radius_m) const {
  if ((p.array() < radius_m).any() || (p.array() > size_m.array() - radius_m).any()) return false;
  for (const world::Body& body : world.bodies) {
    for (const world::Shape& shape : body.visuals) {
      const AlignedBox3d box = world::bounds(shape.geometry, body.pose.T * shape.T_body_shape);
      if (box.max().z() < 0.02 || box.min().z() > kHead_m) continue;
      const Vector2d nearest = p.cwiseMax(box.min().head<2>()).cwiseMin(box.max().head<2>());
      if ((nearest - p).norm() < radius_m) return false;
    }
  }
  return true;
}

TrainingRoom random_room(const world::Catalogue& catalogue, RandomStream& random) {
  return Furnisher(catalogue, random).furnish();
}

}  // namespace amiss::training
