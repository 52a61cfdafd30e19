// How the current room lies on the reference: a rigid motion in x, y, z and yaw for the whole room, and one for each
// half metre of the floor plan, since reconstructions are warped. Point-to-plane ICP with shrinking reach; rotations
// about x and y are fixed (Section 5.2.2).
#pragma once

#include <map>
#include <utility>

#include "change/internal/thinned_scene.hpp"

namespace amiss::change::internal {

class Drift {
 public:
  Drift(const ThinnedScene& reference, const ThinnedScene& current, double reach_m);

  /// T_reference_current where p is.
  [[nodiscard]] const Eigen::Isometry3f& at(const Eigen::Vector3f& p) const;
  [[nodiscard]] const Eigen::Isometry3f& whole() const { return whole_; }

 private:
  using Cell = std::pair<int, int>;
  [[nodiscard]] static Cell cell_of(const Eigen::Vector3f& p);

  Eigen::Isometry3f whole_ = Eigen::Isometry3f::Identity();
  std::map<Cell, Eigen::Isometry3f> local_;
};

}  // namespace amiss::change::internal
