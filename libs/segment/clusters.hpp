// Euclidean clusters: points are in one cluster when a chain of points with steps of at most a distance joins them.
// in: points [m], distance [m], least number of points. out: ascending indices, largest cluster first, equal ones by
// their first index. (Section 5.2.1, tau_segm; Section 5.2.2, tau_filter)
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace amiss::segment {

using Indices = std::vector<std::uint32_t>;

[[nodiscard]] std::vector<Indices> euclidean_clusters(const std::vector<Eigen::Vector3f>& points, float distance_m,
                                                      std::size_t min_points);

/// The same among some of the points; the indices are those of `points`.
[[nodiscard]] std::vector<Indices> euclidean_clusters(const std::vector<Eigen::Vector3f>& points, const Indices& among,
                                                      float distance_m, std::size_t min_points);

}  // namespace amiss::segment
