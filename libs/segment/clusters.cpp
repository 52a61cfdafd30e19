#include "segment/clusters.hpp"

#include <algorithm>
#include <numeric>

#include "segment/point_grid.hpp"

namespace amiss::segment {

std::vector<Indices> euclidean_clusters(const std::vector<Eigen::Vector3f>& points, float distance_m,
                                        std::size_t min_points) {
  const PointGrid grid(points, distance_m);
  std::vector<bool> taken(points.size(), false);
  std::vector<Indices> clusters;
  for (std::uint32_t seed = 0; seed < points.size(); ++seed) {
    if (taken[seed]) continue;
    taken[seed] = true;
    Indices cluster{seed};
    for (std::size_t next = 0; next < cluster.size(); ++next) {
      grid.for_each_within(points[cluster[next]], distance_m, [&](std::uint32_t i, float) {
        if (taken[i]) return;
        taken[i] = true;
        cluster.push_back(i);
      });
    }
    if (cluster.size() < min_points) continue;
    std::sort(cluster.begin(), cluster.end());
    clusters.push_back(std::move(cluster));
  }
  std::stable_sort(clusters.begin(), clusters.end(),
                   [](const Indices& a, const Indices& b) { return a.size() > b.size(); });
  return clusters;
}

std::vector<Indices> euclidean_clusters(const std::vector<Eigen::Vector3f>& points, const Indices& among,
                                        float distance_m, std::size_t min_points) {
  std::vector<Eigen::Vector3f> some;
  some.reserve(among.size());
  for (const std::uint32_t i : among) some.push_back(points[i]);
  std::vector<Indices> clusters = euclidean_clusters(some, distance_m, min_points);
  for (Indices& cluster : clusters) {
    for (std::uint32_t& i : cluster) i = among[i];
  }
  return clusters;
}

}  // namespace amiss::segment
