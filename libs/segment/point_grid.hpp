// Neighbours of places in a fixed set of points: a hash of cubes, filled once.
// in: points [m] (a copy is kept), edge of a cube [m]. out: indices of points, by ascending cube then index; distances
// are squared [m2]. Points must be finite.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace amiss::segment {

class PointGrid {
 public:
  PointGrid(std::vector<Eigen::Vector3f> points, float edge_m);

  /// visit(index, squared distance) for every point at most radius_m away; radius_m <= the cube's edge is fastest.
  template <class Visit>
  void for_each_within(const Eigen::Vector3f& place, float radius_m, Visit visit) const {
    const float limit = radius_m * radius_m;
    const Cube low = cube_of(place.array() - radius_m), high = cube_of(place.array() + radius_m);
    for (int x = low.x; x <= high.x; ++x) {
      for (int y = low.y; y <= high.y; ++y) {
        for (int z = low.z; z <= high.z; ++z) {
          const Range range = range_of({x, y, z});
          for (std::uint32_t k = range.begin; k < range.end; ++k) {
            const float d = (sorted_[k] - place).squaredNorm();
            if (d <= limit) visit(order_[k], d);
          }
        }
      }
    }
  }

  struct Neighbour {
    std::uint32_t index = 0;
    float squared_m2 = 0.0F;
  };
  /// The nearest of the points that `counts`; of equally near ones any, but always the same.
  template <class Counts>
  [[nodiscard]] std::optional<Neighbour> nearest_of(const Eigen::Vector3f& place, float radius_m, Counts counts) const {
    const Cube home = cube_of(place);
    std::optional<Neighbour> best;
    float limit = radius_m * radius_m;
    for (int ring = 0;; ++ring) {
      const float least = least_distance(place, home, ring);
      if (least * least > limit) return best;
      for_each_cube_of_ring(home, ring, [&](Cube cube) {
        const Range range = range_of(cube);
        for (std::uint32_t k = range.begin; k < range.end; ++k) {
          const float d = (sorted_[k] - place).squaredNorm();
          if (d > limit || (best && d == limit) || !counts(order_[k])) continue;
          limit = d;
          best = Neighbour{order_[k], d};
        }
      });
    }
  }
  [[nodiscard]] std::optional<Neighbour> nearest(const Eigen::Vector3f& place, float radius_m) const;
  [[nodiscard]] bool any_within(const Eigen::Vector3f& place, float radius_m) const {
    return nearest(place, radius_m).has_value();
  }
  [[nodiscard]] std::size_t size() const { return order_.size(); }

 private:
  struct Cube {
    int x = 0, y = 0, z = 0;
    bool operator==(const Cube&) const = default;
  };
  struct Range {
    std::uint32_t begin = 0, end = 0;
  };
  struct Slot {
    Cube cube;
    Range range;
  };
  /// Of any point in that ring of cubes round the cube of the place.
  [[nodiscard]] float least_distance(const Eigen::Vector3f& place, Cube home, int ring) const;
  template <class Visit>
  static void for_each_cube_of_ring(Cube c, int ring, Visit visit) {
    for (int x = -ring; x <= ring; ++x) {
      for (int y = -ring; y <= ring; ++y) {
        const bool shell = x == -ring || x == ring || y == -ring || y == ring;
        const int step = shell || ring == 0 ? 1 : 2 * ring;
        for (int z = -ring; z <= ring; z += step) visit(Cube{c.x + x, c.y + y, c.z + z});
      }
    }
  }
  [[nodiscard]] Cube cube_of(const Eigen::Vector3f& p) const;
  [[nodiscard]] std::size_t slot_of(Cube cube) const;  // of the cube, or the free one where it would be
  [[nodiscard]] Range range_of(Cube cube) const { return slots_[slot_of(cube)].range; }

  float edge_m_, inverse_edge_;
  std::vector<Slot> slots_;  // open addressing; an empty range is a free slot
  std::size_t mask_ = 0;
  std::vector<Eigen::Vector3f> sorted_;  // by cube
  std::vector<std::uint32_t> order_;     // index of each of `sorted_`
};

}  // namespace amiss::segment
