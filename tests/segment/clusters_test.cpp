#include "segment/clusters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "core/random.hpp"

namespace amiss::segment {
namespace {

/// Every pair of near points is joined, until nothing changes: slow and obvious.
std::set<Indices> joined(const std::vector<Eigen::Vector3f>& points, float distance_m) {
  std::vector<std::uint32_t> group(points.size());
  std::iota(group.begin(), group.end(), 0U);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t a = 0; a < points.size(); ++a) {
      for (std::size_t b = 0; b < points.size(); ++b) {
        if (group[a] <= group[b] || (points[a] - points[b]).squaredNorm() > distance_m * distance_m) continue;
        group[a] = group[b];
        changed = true;
      }
    }
  }
  std::set<Indices> out;
  for (const std::uint32_t g : std::set<std::uint32_t>(group.begin(), group.end())) {
    Indices members;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if (group[i] == g) members.push_back(i);
    }
    out.insert(members);
  }
  return out;
}

TEST(Clusters, AreWhatJoiningEveryPairGives) {
  RandomStream random(7, "clusters");
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 150; ++i) {
    const auto x = static_cast<float>(random.uniform()), y = static_cast<float>(random.uniform());
    points.emplace_back(x, y, 0.0F);
  }
  const auto clusters = euclidean_clusters(points, 0.06F, 1);
  EXPECT_EQ(std::set<Indices>(clusters.begin(), clusters.end()), joined(points, 0.06F));
  EXPECT_GT(clusters.size(), 3U);
  for (std::size_t k = 1; k < clusters.size(); ++k) EXPECT_GE(clusters[k - 1].size(), clusters[k].size());
}

TEST(Clusters, OfSomePointsKeepTheirIndicesAndDropSmallOnes) {
  const std::vector<Eigen::Vector3f> points = {{0, 0, 0}, {0.01F, 0, 0}, {0.02F, 0, 0}, {1, 0, 0}, {1.01F, 0, 0}};
  EXPECT_EQ(euclidean_clusters(points, {0, 2, 3, 4}, 0.015F, 2), (std::vector<Indices>{{3, 4}}));
}

}  // namespace
}  // namespace amiss::segment
