// Touches, step by step -> collisions: a contact that lasts, or comes back before half a second is over, is one.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/robot_body.hpp"
#include "world/truth.hpp"

namespace amiss::sim {

class CollisionLog {
 public:
  void note(Stamp now, const std::vector<Touch>& touches);
  [[nodiscard]] const std::vector<world::Collision>& collisions() const { return collisions_; }

 private:
  std::vector<world::Collision> collisions_;
  std::map<std::string, Stamp> last_touch_;  // by body
};

}  // namespace amiss::sim
