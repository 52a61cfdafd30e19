// The visits to a room: what lies where on each, and what stands a little elsewhere (thesis 3.2).
// Tidy world, catalogue, random stream -> for each visit nudges and objects at rest. Between two visits some objects
// stay, some are moved, some are gone and new ones come; each kind is there once at most. They lie on furniture and on
// the floor, some against what stands there, some in heaps. InputError when not even one object finds a place.
#pragma once

#include <vector>

#include "robot/model.hpp"
#include "sim/nudging.hpp"
#include "sim/placer.hpp"
#include "world/catalogue.hpp"

namespace amiss::sim {

struct VisitsParams {
  double on_floor = 0.15;  // parts of the objects that are placed; the rest lies freely on furniture
  double in_heaps = 0.15;
  double against = 0.25;
  double stay = 0.25;  // parts of the objects of the visit before; the rest is gone
  double move = 0.40;
  ScatterParams scatter{.object_distance_m = 0.3, .start_distance_m = 1.2};  // a raised camera sees no floor nearer
  PlacerParams placer;
  NudgingParams nudging;
};
void describe(ParamTable& table, VisitsParams& params);

struct Visit {
  std::vector<world::Nudge> nudges;
  std::vector<ScatteredObject> objects;
};

struct VisitedRoom {
  const world::World& world;
  const world::ClassTable& classes;
  const world::Catalogue& catalogue;
  const robot::Model& model;
  Pose2<amiss::World, Base> start;
  std::vector<Point<amiss::World>> eyes;  // objects on furniture are seen from one of them
};

/// As many visits as counts, each with that number of objects (fewer where no room is found for more).
[[nodiscard]] std::vector<Visit> make_visits(const VisitedRoom& room, const std::vector<int>& counts,
                                             const VisitsParams& params, RandomStream random);

}  // namespace amiss::sim
