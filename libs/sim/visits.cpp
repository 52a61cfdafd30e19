#include "sim/visits.hpp"

#include <algorithm>
#include <optional>

#include "core/result.hpp"
#include "sim/internal/falling.hpp"

namespace amiss::sim {
namespace {

constexpr double kOnFloor_m = 0.1;  // feet below this have no furniture under them
constexpr int kSpareKinds = 24;     // tried beyond the number wanted

using Kinds = std::vector<const world::CatalogueEntry*>;

void shuffle(Kinds& kinds, RandomStream& random) {
  for (std::size_t i = kinds.size(); i > 1; --i) std::swap(kinds[i - 1], kinds[random.below(i)]);
}

/// What becomes of the objects of the visit before, and what is new.
struct Plan {
  std::vector<ScatteredObject> stay;
  Kinds place;  // moved ones first, then new ones; more of these than are wanted
};

class VisitMaker {
 public:
  VisitMaker(const VisitedRoom& room, const VisitsParams& params, RandomStream random)
      : room_(room), params_(params), random_(random) {}

  Visit next(const Visit& before, std::size_t count) {
    Visit visit;
    visit.nudges = random_nudges(room_.world, room_.classes, params_.nudging, random_);
    const world::World world = world::nudged(room_.world, visit.nudges);
    const Plan plan = plan_visit(before, count);
    Placer placer(world, room_.eyes, params_.placer);
    for (const ScatteredObject& object : carried(plan.stay, before, world)) {
      placer.keep(object, room_.catalogue.at(object.kind).body);
    }
    std::size_t there = placer.objects().size();
    for (const world::CatalogueEntry* entry : plan.place) {
      if (there < count && put(*entry, world, placer)) ++there;
    }
    visit.objects = placer.objects();
    return visit;
  }

 private:
  [[nodiscard]] Plan plan_visit(const Visit& before, std::size_t count) {
    Plan plan;
    Kinds fresh;
    for (const world::CatalogueEntry& entry : room_.catalogue.entries) {
      const auto same = [&](const ScatteredObject& object) { return object.kind == entry.name; };
      const auto was = std::find_if(before.objects.begin(), before.objects.end(), same);
      if (was == before.objects.end()) {
        fresh.push_back(&entry);
        continue;
      }
      const double fate = random_.uniform();
      if (fate < params_.stay && plan.stay.size() < count) {
        plan.stay.push_back(*was);
      } else if (fate < params_.stay + params_.move) {
        plan.place.push_back(&entry);
      }
    }
    shuffle(plan.place, random_);
    shuffle(fresh, random_);
    const std::size_t wanted = count - std::min(count, plan.stay.size());
    const std::size_t missing = wanted + kSpareKinds - std::min(wanted + kSpareKinds, plan.place.size());
    fresh.resize(std::min(fresh.size(), missing));
    plan.place.insert(plan.place.end(), fresh.begin(), fresh.end());
    return plan;
  }

  /// The objects on furniture that stands elsewhere now go with it; the lowest first.
  [[nodiscard]] std::vector<ScatteredObject> carried(std::vector<ScatteredObject> objects, const Visit& before,
                                                     const world::World& now) const {
    const world::World then = world::nudged(room_.world, before.nudges);
    const std::vector<Support> supports = find_supports(then, params_.placer.supports);
    std::vector<std::pair<double, ScatteredObject>> sorted;
    for (ScatteredObject& object : objects) {
      const world::Body& body = room_.catalogue.at(object.kind).body;
      const Eigen::Vector3d foot = foot_of(internal::turned(body, object.pose.T).bounds);
      if (const auto carrier = carrier_of(supports, foot)) {
        object.pose.T = now.bodies[*carrier].pose.T * then.bodies[*carrier].pose.T.inverse() * object.pose.T;
      }
      sorted.emplace_back(foot.z(), std::move(object));
    }
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<ScatteredObject> result;
    for (auto& [foot_z_m, object] : sorted) result.push_back(std::move(object));
    return result;
  }
  /// The body whose top is the highest one under the foot.
  [[nodiscard]] static std::optional<std::size_t> carrier_of(const std::vector<Support>& supports,
                                                             const Eigen::Vector3d& foot) {
    std::optional<std::size_t> carrier;
    double highest_m = kOnFloor_m;
    for (const Support& support : supports) {
      if (support.height_m() < highest_m || support.height_m() > foot.z() + 0.02) continue;
      if (!support.is_over(foot.head<2>())) continue;
      highest_m = support.height_m();
      carrier = support.body;
    }
    return carrier;
  }

  bool put(const world::CatalogueEntry& entry, const world::World& world, Placer& placer) {
    const double where = random_.uniform();
    if (where < params_.on_floor) return put_on_floor(entry, world, placer);
    const bool in_heap = where < params_.on_floor + params_.in_heaps;
    const bool against = !in_heap && where < params_.on_floor + params_.in_heaps + params_.against;
    const Manner manner = in_heap ? Manner::kHeap : against ? Manner::kAgainst : Manner::kFree;
    if (placer.place(entry.name, entry.name, entry.body, manner, random_)) return true;
    return manner != Manner::kFree && placer.place(entry.name, entry.name, entry.body, Manner::kFree, random_);
  }

  bool put_on_floor(const world::CatalogueEntry& entry, const world::World& world, Placer& placer) {
    world::World full = world;
    for (const ScatteredObject& object : placer.objects()) {
      full.bodies.push_back(room_.catalogue.at(object.kind).body);
      full.bodies.back().name = object.name;
      full.bodies.back().pose = object.pose;
    }
    world::Catalogue only;
    only.entries = {entry};
    try {
      const auto scattered = scatter(1, only, full, room_.model, room_.start, random_.child("floor"), params_.scatter);
      return placer.keep(scattered.front(), entry.body);
    } catch (const InputError&) {
      return false;  // no room left on the floor
    }
  }

  const VisitedRoom& room_;
  const VisitsParams& params_;
  RandomStream random_;
};

}  // namespace

void describe(ParamTable& table, VisitsParams& params) {
  table.number("visits.on_floor", params.on_floor, "", 0.0, 1.0, "part of the placed objects on the floor");
  table.number("visits.in_heaps", params.in_heaps, "", 0.0, 1.0, "part that lies on or beside others");
  table.number("visits.against", params.against, "", 0.0, 1.0, "part that is pushed against what stands there");
  table.number("visits.stay", params.stay, "", 0.0, 1.0, "part of the objects that stays till the next visit");
  table.number("visits.move", params.move, "", 0.0, 1.0, "part that lies elsewhere on the next visit");
  describe(table, params.placer);
  describe(table, params.nudging);
}

std::vector<Visit> make_visits(const VisitedRoom& room, const std::vector<int>& counts, const VisitsParams& params,
                               RandomStream random) {
  VisitMaker maker(room, params, random);
  std::vector<Visit> visits;
  Visit before;
  for (const int count : counts) {
    if (count < 0) throw ArgumentError("objects: " + std::to_string(count) + "; 0 or more are allowed");
    before = maker.next(before, static_cast<std::size_t>(count));
    if (count > 0 && before.objects.empty()) {
      throw InputError(room.world.file.string() + ": no object finds a place in it");
    }
    visits.push_back(before);
  }
  return visits;
}

}  // namespace amiss::sim
