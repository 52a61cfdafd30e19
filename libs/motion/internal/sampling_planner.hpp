// Informed RRT* (Gammell, Srinivasa and Barfoot 2014) in the plane, by OMPL, over the passable cells of a DriveMap.
#pragma once

#include <optional>
#include <vector>

#include "core/random.hpp"
#include "motion/drive_map.hpp"

namespace amiss::motion::internal {

struct SamplingTask {
  std::vector<Eigen::Vector2d> guide;  // a way from start to goal; half of the samples lie near it
  double clearance_weight = 0.0;
  int iterations = 0;
};

/// Corners of the cheapest way found, none where the iterations did not suffice. Same stream, same way.
[[nodiscard]] std::optional<std::vector<Eigen::Vector2d>> sample_way(const DriveMap& map, const SamplingTask& task,
                                                                     RandomStream& random);

}  // namespace amiss::motion::internal
