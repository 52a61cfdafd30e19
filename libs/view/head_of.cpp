#include "robot/model.hpp"
#include "view/head.hpp"

namespace amiss::view {

Head head_of(const robot::Model& model) {
  return {model.camera, model.limits.tilt_min_rad, model.limits.tilt_max_rad,
          [&model](const robot::HeadState& state) { return model.T_base_camera(state); }};
}

}  // namespace amiss::view
