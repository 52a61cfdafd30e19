#include "sim/collision_log.hpp"

namespace amiss::sim {

using namespace std::chrono_literals;

void CollisionLog::note(Stamp now, const std::vector<Touch>& touches) {
  for (const Touch& touch : touches) {
    const auto known = last_touch_.find(touch.body);
    if (known == last_touch_.end() || now - known->second > 500ms) {
      collisions_.push_back({now, touch.link, touch.body, touch.position});
    }
    last_touch_[touch.body] = now;
  }
}

}  // namespace amiss::sim
