// What every map asks of a frame before it changes anything.
#pragma once

#include "core/sensors.hpp"

namespace amiss::mapping {

/// Origins and points of rays must lie within the map's limits.
[[nodiscard]] bool reachable(const Eigen::Vector3d& p, double resolution_m);

/// InputError for sizes that do not fit, intrinsics or a pose that are not finite or out of the map's limits.
void check_frame(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera, double resolution_m);

}  // namespace amiss::mapping
