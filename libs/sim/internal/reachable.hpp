// Where a disc can go from its start, and what changes when something more stands in the way.
#pragma once

#include <vector>

#include "core/floor_grid.hpp"

namespace amiss::sim::internal {

class ReachableSpace {
 public:
  /// `plan`: what stands on the floor. The start counts with the nearest free place within 0.5 m.
  ReachableSpace(FloorGrid plan, const Eigen::Vector2d& start, double radius_m);

  [[nodiscard]] bool can_start() const;
  /// Can the disc's middle come as near to p as this?
  [[nodiscard]] bool comes_within(const Eigen::Vector2d& p, double distance_m) const;
  /// Stands a disc there for good, unless this would cut off places that were reachable, or the way to it or to one of
  /// those that stood before; false and nothing changed then.
  [[nodiscard]] bool try_to_block(const Eigen::Vector2d& p, double radius_m, double reach_m);

 private:
  struct Blocked {
    Eigen::Vector2d p;
    double reach_m;
  };
  void update();

  FloorGrid plan_;
  Eigen::Vector2d start_;
  double radius_m_;
  FloorGrid room_;           // free where the disc's middle can be
  std::vector<int> labels_;  // connected areas of it
  int start_label_ = 0;      // 0: the start is not free
  std::vector<Blocked> blocked_;
};

}  // namespace amiss::sim::internal
