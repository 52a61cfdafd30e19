// What every labeller asks of a cloud: ArgumentError with one sentence otherwise.
#pragma once

#include <string>

#include "core/frames.hpp"
#include "core/result.hpp"

namespace amiss::semantics {

inline void check_cloud(const Cloud<Map>& cloud) {
  const auto fits = [&](std::size_t size) { return size == 0 || size == cloud.points.size(); };
  if (fits(cloud.colours.size()) && fits(cloud.normals.size())) return;
  throw ArgumentError("a cloud to be labelled: " + std::to_string(cloud.points.size()) + " points, " +
                      std::to_string(cloud.colours.size()) + " colours, " + std::to_string(cloud.normals.size()) +
                      " normals; as many as points, or none, are allowed");
}

}  // namespace amiss::semantics
