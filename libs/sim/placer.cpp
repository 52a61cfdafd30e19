#include "sim/placer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/result.hpp"
#include "sim/internal/falling.hpp"

namespace amiss::sim {
namespace {

constexpr double kSinks_m = 0.02;         // lower than its surface: it fell off
constexpr double kStaysWithin_m = 0.05;   // of where it was put back
constexpr double kBeside_m = 0.05;        // from the middle of what a heap is made on
constexpr double kHeapWithin_m = 0.03;    // between the bounds of things of a heap
constexpr double kTouch_m = 0.002;        // bodies that lie against each other overlap by less
constexpr double kPushStep_m = 0.01;
constexpr double kLongestPush_m = 0.8;
constexpr double kOverRim = 0.7;          // part of its half width that stays over the surface

bool overlaps(const Physics& physics, std::size_t body) {
  const std::optional<double> gap_m = physics.distance_to_others(body, 0.005);
  return gap_m && *gap_m < -kTouch_m;
}

}  // namespace

void describe(ParamTable& table, PlacerParams& params) {
  table.number("placer.min_height", params.supports.min_height_m, "m", 0.0, 2.0, "of a surface above the floor");
  table.number("placer.max_height", params.supports.max_height_m, "m", 0.1, 3.0, "of a surface above the floor");
  table.number("placer.min_edge", params.supports.min_edge_m, "m", 0.05, 2.0, "shorter edge of a surface");
  table.number("placer.drop_height", params.drop_height_m, "m", 0.005, 0.3, "from which objects fall");
  table.number("placer.seen_within", params.seen_within_m, "m", 0.5, 10.0, "from one of the eyes");
  table.integer("placer.tries", params.tries, 1, 10000, "places tried for one object");
}

Placer::Placer(const world::World& world, std::vector<Point<amiss::World>> eyes, const PlacerParams& params)
    : params_(params), eyes_(std::move(eyes)), physics_(world), supports_(find_supports(world, params.supports)) {
  internal::settle(physics_);
  double sum = 0.0;
  for (const Support& support : supports_) shares_.push_back(sum += std::sqrt(support.area_m2()));
}

const Support& Placer::random_support(RandomStream& random) const {
  const double at = random.uniform(0.0, shares_.back());
  const auto found = std::upper_bound(shares_.begin(), shares_.end(), at);
  return supports_[std::min(static_cast<std::size_t>(found - shares_.begin()), supports_.size() - 1)];
}

bool Placer::keep(const ScatteredObject& object, const world::Body& body) {
  const auto before = poses();
  world::Body resting = body;
  resting.is_static = false;
  resting.pose = object.pose;
  const std::size_t index = physics_.add(resting);
  const std::optional<Support> under = support_under(supports_, foot_of(physics_.bounds(index)));
  const double level_m = under ? under->height_m() : physics_.bounds(index).min().z();
  const Eigen::Vector3d was = physics_.bounds(index).center();
  const bool rests = !overlaps(physics_, index) && internal::settle(physics_);
  // One that slips off a low thing stays near: it would never lie on its level, and all that comes later be refused.
  const bool stays = (physics_.bounds(index).center() - was).norm() < kStaysWithin_m &&
                     physics_.bounds(index).min().z() > level_m - kSinks_m;
  if (rests && stays && all_lie_well()) {
    placed_.push_back({index, object.kind, object.name, level_m});
    return true;
  }
  undo(index, before);
  return false;
}

bool Placer::place(const std::string& kind, const std::string& name, const world::Body& body, Manner manner,
                   RandomStream& random) {
  if (supports_.empty() || (manner == Manner::kHeap && placed_.empty())) return false;
  const auto before = poses();
  for (int i = 0; i < params_.tries; ++i) {
    const std::optional<Lowered> lowered = lower(body, manner, random);
    if (!lowered) continue;
    if (manner == Manner::kAgainst) push(*lowered, random);
    if (internal::settle(physics_) && lies_well(*lowered) && all_lie_well() && is_seen(lowered->body)) {
      placed_.push_back({lowered->body, kind, name, lowered->onto.height_m()});
      return true;
    }
    undo(lowered->body, before);
  }
  return false;
}

/// Over a surface, or over something that lies on one; nothing where there is no room for it.
std::optional<Placer::Lowered> Placer::lower(const world::Body& body, Manner manner, RandomStream& random) {
  internal::Turned falling = internal::turned(body, internal::random_turn(random));
  Support onto = random_support(random);
  Eigen::Vector3d foot = onto.T_world_top * Eigen::Vector3d(random.uniform(-1.0, 1.0) * onto.half_m.x(),
                                                            random.uniform(-1.0, 1.0) * onto.half_m.y(), 0.0);
  if (manner == Manner::kHeap) {
    const Placed& below = placed_[random.below(placed_.size())];
    const Eigen::AlignedBox3d box = physics_.bounds(below.body);
    const std::optional<Support> under = support_under(supports_, {box.center().x(), box.center().y(), below.level_m});
    if (!under) return std::nullopt;
    onto = *under;
    foot = {box.center().x() + random.uniform(-kBeside_m, kBeside_m),
            box.center().y() + random.uniform(-kBeside_m, kBeside_m), box.max().z()};
  }
  const double margin_m = kOverRim * 0.5 * falling.bounds.sizes().head<2>().maxCoeff();
  if (!onto.is_over(foot.head<2>(), margin_m)) return std::nullopt;
  falling.body.pose.T.pretranslate(foot + Eigen::Vector3d(0.0, 0.0, params_.drop_height_m) - foot_of(falling.bounds));
  const std::size_t index = physics_.add(falling.body);
  if (overlaps(physics_, index)) {
    physics_.remove(index);
    return std::nullopt;
  }
  return Lowered{index, onto};
}

/// Level in a random direction until it touches something, but not off its surface.
void Placer::push(const Lowered& lowered, RandomStream& random) {
  const double about = random.uniform(-std::numbers::pi, std::numbers::pi);
  const Eigen::Vector3d step = kPushStep_m * Eigen::Vector3d(std::cos(about), std::sin(about), 0.0);
  Transform<amiss::World, Object> here = physics_.pose(lowered.body);
  for (double way_m = 0.0; way_m < kLongestPush_m; way_m += kPushStep_m) {
    Transform<amiss::World, Object> next = here;
    next.T.pretranslate(step);
    physics_.place(lowered.body, next);
    const bool over = lowered.onto.is_over(physics_.bounds(lowered.body).center().head<2>(), 0.02);
    if (!over || overlaps(physics_, lowered.body)) break;
    here = next;
  }
  physics_.place(lowered.body, here);
}

bool Placer::lies_well(const Lowered& lowered) const {
  const Eigen::AlignedBox3d box = physics_.bounds(lowered.body);
  const double above_m = box.min().z() - lowered.onto.height_m();
  if (above_m < -kSinks_m || !lowered.onto.is_over(box.center().head<2>())) return false;
  if (above_m < kSinks_m) return true;
  // Higher than its surface: on something that was put there, not on a lamp.
  return std::any_of(placed_.begin(), placed_.end(), [&](const Placed& other) {
    return physics_.bounds(other.body).exteriorDistance(box) < kHeapWithin_m;
  });
}

bool Placer::all_lie_well() const {
  return std::all_of(placed_.begin(), placed_.end(), [&](const Placed& object) {
    return physics_.is_asleep(object.body) && physics_.bounds(object.body).min().z() > object.level_m - kSinks_m;
  });
}

/// Its top and half of its height on the side of the eye are in sight.
bool Placer::is_seen(std::size_t body) const {
  if (eyes_.empty()) return true;
  const Eigen::AlignedBox3d box = physics_.bounds(body);
  const std::vector<Eigen::Vector3d> spots{box.center(), {box.center().x(), box.center().y(), box.max().z() - 0.005}};
  return std::any_of(eyes_.begin(), eyes_.end(), [&](const Point<amiss::World>& eye) {
    if ((box.center() - eye.p).norm() > params_.seen_within_m) return false;
    return std::all_of(spots.begin(), spots.end(), [&](const Eigen::Vector3d& spot) {
      const Eigen::Vector3d beyond = spot + 0.02 * (spot - eye.p).normalized();
      const auto hit = physics_.cast_ray(eye, {beyond});
      return hit && (hit->body == body || hit->range_m > (spot - eye.p).norm() - 0.01);
    });
  });
}

void Placer::undo(std::size_t body, const std::vector<Transform<amiss::World, Object>>& before) {
  physics_.remove(body);
  for (std::size_t i = 0; i < placed_.size(); ++i) physics_.place(placed_[i].body, before[i]);
  internal::settle(physics_);
}

std::vector<Transform<amiss::World, Object>> Placer::poses() const {
  std::vector<Transform<amiss::World, Object>> now;
  for (const Placed& object : placed_) now.push_back(physics_.pose(object.body));
  return now;
}

std::vector<ScatteredObject> Placer::objects() const {
  std::vector<ScatteredObject> now;
  for (const Placed& object : placed_) now.push_back({object.kind, object.name, physics_.pose(object.body)});
  return now;
}

}  // namespace amiss::sim
