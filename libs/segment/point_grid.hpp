// Neighbours of places in a fixed set of points: a hash of bricks of 4 x 4 x 4 cubes, filled once. A brick knows by one
// bit which of its cubes hold points, so that most of the empty ones around a place cost no look at memory.
// in: points [m] (a copy is kept), edge of a cube [m]. out: indices of points, by ascending cube then index; distances
// are squared [m2]. Points must be finite.
#pragma once

#include <Eigen/Core>
#include <bit>
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
    Cursor cursor(*this);
    for (int x = low.x; x <= high.x; ++x) {
      for (int y = low.y; y <= high.y; ++y) {
        for (int z = low.z; z <= high.z; ++z) {
          const Range range = cursor.range_of({x, y, z});
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
    Cursor cursor(*this);
    for (int ring = 0;; ++ring) {
      const float least = least_distance(place, home, ring);
      if (least * least > limit) return best;
      for_each_cube_of_ring(home, ring, [&](Cube cube) {
        const Range range = cursor.range_of(cube);
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
  struct Brick {
    Cube place;               // of a cube in it, / 4
    std::uint64_t cubes = 0;  // a bit for each that holds points; none: a free slot
    std::uint32_t first = 0;  // of its cubes in `begins_`
  };
  /// Looks a brick up only when it is another one than before.
  class Cursor {
   public:
    explicit Cursor(const PointGrid& grid) : grid_(grid) {}
    [[nodiscard]] Range range_of(const Cube& cube) {
      const Cube place = brick_of(cube);
      if (brick_ == nullptr || !(place == place_)) {
        place_ = place;
        brick_ = &grid_.bricks_[grid_.slot_of(place)];
      }
      const std::uint64_t bit = std::uint64_t{1} << number_in_brick(cube);
      if ((brick_->cubes & bit) == 0) return {};
      const auto before = static_cast<std::uint32_t>(std::popcount(brick_->cubes & (bit - 1)));
      const std::uint32_t* const begin = &grid_.begins_[brick_->first + before];
      return {begin[0], begin[1]};
    }

   private:
    const PointGrid& grid_;
    const Brick* brick_ = nullptr;
    Cube place_;
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
  [[nodiscard]] static Cube brick_of(const Cube& c) { return {c.x >> 2, c.y >> 2, c.z >> 2}; }
  /// 0 to 63, z fastest.
  [[nodiscard]] static unsigned number_in_brick(const Cube& c) {
    return static_cast<unsigned>((c.x & 3) << 4 | (c.y & 3) << 2 | (c.z & 3));
  }
  [[nodiscard]] std::size_t slot_of(const Cube& brick) const;  // of the brick, or the free one where it would be
  void put_bricks(const std::vector<Cube>& cubes);             // of the points

  float edge_m_, inverse_edge_;
  std::vector<Brick> bricks_;  // open addressing
  std::size_t mask_ = 0;
  std::vector<std::uint32_t> begins_;    // of each cube that holds points, in `sorted_`; then the number of all
  std::vector<Eigen::Vector3f> sorted_;  // by brick, then cube
  std::vector<std::uint32_t> order_;     // index of each of `sorted_`
};

}  // namespace amiss::segment
