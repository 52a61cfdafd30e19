#include "sim/scatter.hpp"

#include <algorithm>
#include <map>

#include "core/result.hpp"
#include "sim/internal/falling.hpp"
#include "sim/internal/reachable.hpp"
#include "sim/physics.hpp"

namespace amiss::sim {
namespace {

using namespace std::chrono_literals;

constexpr double kFloorTolerance_m = 0.012;  // a rug may lie under an object
constexpr double kUnderFurniture_m = 0.3;    // up to here everything is furniture to keep away from
constexpr int kTries = 400;                  // places tried for one object
constexpr int kKindsTried = 3;               // kinds tried before a place for one more object is given up

/// The world while objects are dropped into it one by one.
class Dropping {
 public:
  Dropping(const world::World& world, const robot::Model& model, const Pose2<amiss::World, Base>& start,
           const ScatterParams& params)
      : params_(params),
        start_(start.position()),
        physics_(world),
        low_(floor_plan(world, kCell_m, kLowestObstacle_m, kUnderFurniture_m, true)),
        free_above_(
            distance_to_occupied_m(floor_plan(world, kCell_m, kLowestObstacle_m, params.free_above_m, true), false)),
        space_(floor_plan(world, kCell_m, kLowestObstacle_m, model.height_m, true), start_, params.robot_radius_m) {
    for (int i = 0; i < 250 && !physics_.all_asleep(); ++i) physics_.step(20ms);
  }

  [[nodiscard]] bool can_start() const { return space_.can_start(); }
  /// One attempt; the pose at rest where all conditions hold.
  [[nodiscard]] std::optional<Transform<amiss::World, Object>> drop(const world::Body& body, RandomStream& random);

 private:
  static constexpr double kCell_m = 0.05;

  [[nodiscard]] std::optional<Eigen::Vector2d> place(double radius_m, RandomStream& random) const;
  [[nodiscard]] bool is_apart(const Eigen::Vector2d& p) const;
  [[nodiscard]] bool has_free_sky(const Eigen::Vector2d& p, double radius_m) const;
  [[nodiscard]] bool lies_well(std::size_t body) const;

  ScatterParams params_;
  Eigen::Vector2d start_;
  Physics physics_;
  FloorGrid low_;
  std::vector<float> free_above_;  // distance to the nearest cell with anything above it
  internal::ReachableSpace space_;
  std::vector<Eigen::Vector2d> placed_;
};

bool Dropping::is_apart(const Eigen::Vector2d& p) const {
  if ((p - start_).norm() < params_.start_distance_m) return false;
  return std::all_of(placed_.begin(), placed_.end(),
                     [&](const Eigen::Vector2d& q) { return (p - q).norm() >= params_.object_distance_m; });
}

bool Dropping::has_free_sky(const Eigen::Vector2d& p, double radius_m) const {
  const Cell cell = low_.cell_at(p);
  // Half a cell's diagonal: the centre of a cell stands for all of it.
  return low_.contains(cell) && static_cast<double>(free_above_[low_.index(cell)]) >= radius_m + 0.71 * kCell_m;
}

/// A place that may do, before anything is dropped there.
std::optional<Eigen::Vector2d> Dropping::place(double radius_m, RandomStream& random) const {
  const Eigen::Vector2d extent = kCell_m * Eigen::Vector2d(low_.width(), low_.height());
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d p =
        low_.origin_m() + extent.cwiseProduct(Eigen::Vector2d(random.uniform(), random.uniform()));
    const double apart_m = std::max(0.0, params_.furniture_distance_m);
    if (is_apart(p) && has_free_sky(p, radius_m + apart_m) && space_.comes_within(p, params_.reach_m)) return p;
  }
  return std::nullopt;
}

/// At rest on the floor, clear of everything, and nothing above.
bool Dropping::lies_well(std::size_t body) const {
  const Eigen::AlignedBox3d box = physics_.bounds(body);
  if (!physics_.is_asleep(body) || std::abs(box.min().z()) > kFloorTolerance_m) return false;
  const Eigen::Vector2d p = box.center().head<2>();
  const double radius_m = 0.5 * box.sizes().head<2>().norm();
  return is_apart(p) && has_free_sky(p, radius_m) && !physics_.distance_to_others(body, params_.furniture_distance_m);
}

std::optional<Transform<amiss::World, Object>> Dropping::drop(const world::Body& body, RandomStream& random) {
  internal::Turned falling = internal::turned(body, internal::random_turn(random));
  const Eigen::AlignedBox3d& box = falling.bounds;
  const std::optional<Eigen::Vector2d> p = place(0.5 * box.sizes().head<2>().norm(), random);
  if (!p) return std::nullopt;
  const Eigen::Vector3d centre(p->x(), p->y(), params_.drop_height_m + 0.5 * box.sizes().z());
  falling.body.pose.T.pretranslate(centre - box.center());

  const std::size_t index = physics_.add(falling.body);
  internal::settle(physics_, index);
  const Eigen::AlignedBox3d at_rest = physics_.bounds(index);
  const Eigen::Vector2d middle = at_rest.center().head<2>();
  if (lies_well(index) && space_.try_to_block(middle, 0.5 * at_rest.sizes().head<2>().norm(), params_.reach_m)) {
    placed_.push_back(middle);
    return physics_.pose(index);
  }
  physics_.remove(index);
  return std::nullopt;
}

/// The kinds in random order, again and again in a new one.
class Kinds {
 public:
  Kinds(const world::Catalogue& catalogue, RandomStream& random) : catalogue_(catalogue), random_(random) {}
  const world::CatalogueEntry& next() {
    if (order_.empty()) {
      for (const world::CatalogueEntry& entry : catalogue_.entries) order_.push_back(&entry);
      for (std::size_t i = order_.size(); i > 1; --i) std::swap(order_[i - 1], order_[random_.below(i)]);
    }
    const world::CatalogueEntry* entry = order_.back();
    order_.pop_back();
    return *entry;
  }

 private:
  const world::Catalogue& catalogue_;
  RandomStream& random_;
  std::vector<const world::CatalogueEntry*> order_;
};

std::optional<ScatteredObject> drop_one(Dropping& dropping, Kinds& kinds, RandomStream& random) {
  for (int kind = 0; kind < kKindsTried; ++kind) {
    const world::CatalogueEntry& entry = kinds.next();
    for (int i = 0; i < kTries / kKindsTried; ++i) {
      if (const auto pose = dropping.drop(entry.body, random)) return ScatteredObject{entry.name, entry.name, *pose};
    }
  }
  return std::nullopt;
}

/// The kind, with _2, _3 .. where the world or an earlier object has that name.
std::string unique_name(const std::string& kind, const world::World& world,
                        const std::vector<ScatteredObject>& so_far) {
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(world.bodies.begin(), world.bodies.end(), [&](const auto& b) { return b.name == name; }) ||
           std::any_of(so_far.begin(), so_far.end(), [&](const auto& o) { return o.name == name; });
  };
  std::string name = kind;
  for (int i = 2; is_taken(name); ++i) name = kind + "_" + std::to_string(i);
  return name;
}

}  // namespace

void describe(ParamTable& table, ScatterParams& params) {
  table.number("scatter.furniture_distance", params.furniture_distance_m, "m", 0.0, 2.0, "from object to furniture");
  table.number("scatter.object_distance", params.object_distance_m, "m", 0.0, 5.0, "between the middles of objects");
  table.number("scatter.start_distance", params.start_distance_m, "m", 0.0, 10.0, "from the robot's start");
  table.number("scatter.free_above", params.free_above_m, "m", 0.1, 3.0, "free height over an object");
  table.number("scatter.reach", params.reach_m, "m", 0.35, 3.0, "the robot's middle comes as near as this");
  table.number("scatter.robot_radius", params.robot_radius_m, "m", 0.1, 1.0, "of the disc that needs a free path");
  table.number("scatter.drop_height", params.drop_height_m, "m", 0.0, 0.5, "from which objects fall");
}

std::vector<ScatteredObject> scatter(int count, const world::Catalogue& catalogue, const world::World& world,
                                     const robot::Model& model, const Pose2<amiss::World, Base>& start,
                                     RandomStream random, const ScatterParams& params) {
  if (count < 0) throw ArgumentError("objects: " + std::to_string(count) + "; 0 or more are allowed");
  std::vector<ScatteredObject> out;
  if (count == 0) return out;
  if (catalogue.entries.empty()) throw InputError("the object catalogue is empty; at least one object is needed");
  Dropping dropping(world, model, start, params);
  if (!dropping.can_start()) {
    throw InputError(world.file.string() + ": the robot cannot move at its start (" + std::to_string(start.x_m) + ", " +
                     std::to_string(start.y_m) + "); a disc of " + std::to_string(params.robot_radius_m) +
                     " m radius must be free within 0.5 m of it");
  }
  Kinds kinds(catalogue, random);
  while (static_cast<int>(out.size()) < count) {
    std::optional<ScatteredObject> object = drop_one(dropping, kinds, random);
    if (!object) {
      throw InputError(world.file.string() + ": room for " + std::to_string(out.size()) + " of " +
                       std::to_string(count) + " objects on the floor; ask for fewer or relax scatter.*_distance");
    }
    object->name = unique_name(object->kind, world, out);
    out.push_back(std::move(*object));
  }
  return out;
}

}  // namespace amiss::sim
