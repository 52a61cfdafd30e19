// Puts objects onto furniture, one by one, and lets them fall: freely, pushed against what stands there, or onto one
// another. World and object -> the pose at which it rests (in the world frame), from a random stream; nothing where no
// place was found. What is placed lies on the surface it was meant for, leaves all that lay before where it lay or at
// least on its surface, and is seen from one of the given eyes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/params.hpp"
#include "core/random.hpp"
#include "sim/physics.hpp"
#include "sim/scatter.hpp"
#include "sim/supports.hpp"

namespace amiss::sim {

struct PlacerParams {
  SupportParams supports;
  double drop_height_m = 0.02;
  double seen_within_m = 1.8;  // from an eye
  int tries = 150;             // for one object
};
void describe(ParamTable& table, PlacerParams& params);

enum class Manner { kFree, kAgainst, kHeap };

class Placer {
 public:
  /// `eyes`: where the camera will look from. Movable bodies of the world may be pushed, and are not told of.
  Placer(const world::World& world, std::vector<Point<amiss::World>> eyes, const PlacerParams& params = {});

  /// Puts an object where it lay, and lets it rest there: false, and nothing changed, when it does not stay.
  bool keep(const ScatteredObject& object, const world::Body& body);
  /// A new place; kHeap needs something that lies there already. False when none was found.
  bool place(const std::string& kind, const std::string& name, const world::Body& body, Manner manner,
             RandomStream& random);

  /// All of them, where they lie now.
  [[nodiscard]] std::vector<ScatteredObject> objects() const;

 private:
  struct Placed {
    std::size_t body;
    std::string kind, name;
    double level_m;  // height of the surface that it lies on
  };
  /// A body that has been let down into the world, over its surface.
  struct Lowered {
    std::size_t body;
    Support onto;
  };

  [[nodiscard]] const Support& random_support(RandomStream& random) const;
  [[nodiscard]] std::optional<Lowered> lower(const world::Body& body, Manner manner, RandomStream& random);
  void push(const Lowered& lowered, RandomStream& random);
  [[nodiscard]] bool lies_well(const Lowered& lowered) const;
  [[nodiscard]] bool all_lie_well() const;
  [[nodiscard]] bool is_seen(std::size_t body) const;
  void undo(std::size_t body, const std::vector<Transform<amiss::World, Object>>& before);
  [[nodiscard]] std::vector<Transform<amiss::World, Object>> poses() const;

  PlacerParams params_;
  std::vector<Point<amiss::World>> eyes_;
  Physics physics_;
  std::vector<Support> supports_;
  std::vector<double> shares_;  // running sum of the weights of supports_
  std::vector<Placed> placed_;
};

}  // namespace amiss::sim
