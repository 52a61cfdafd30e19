// Where things can be put: level tops of what stands in a world (table tops, boards, seats, counters).
// World -> flat boxes and discs of its static bodies in the world frame [m], in the order of bodies and shapes. Boxes
// and upright cylinders among the collision shapes count, meshes do not; a cylinder that is higher than its radius is a
// lamp shade or the crown of a plant, no table. What stands above a top is not asked for.
#pragma once

#include <optional>
#include <vector>

#include "world/world.hpp"

namespace amiss::sim {

struct SupportParams {
  double min_height_m = 0.10;  // lower is floor
  double max_height_m = 1.15;  // higher nobody sees
  double min_edge_m = 0.25;    // shorter edge of a box, diameter of a disc
};

struct Support {
  std::size_t body = 0;                                          // index in the world's bodies
  Eigen::Isometry3d T_world_top = Eigen::Isometry3d::Identity();  // origin in the middle of the top, z up
  Eigen::Vector2d half_m = Eigen::Vector2d::Zero();              // half edges; the radius twice for a disc
  bool is_round = false;

  [[nodiscard]] double height_m() const { return T_world_top.translation().z(); }
  [[nodiscard]] double area_m2() const;
  /// Over the top, at least `margin_m` inside its rim.
  [[nodiscard]] bool is_over(const Eigen::Vector2d& p_world, double margin_m = 0.0) const;
};

[[nodiscard]] std::vector<Support> find_supports(const world::World& world, const SupportParams& params = {});

/// The support that something with its foot there stands on: a top within 2 cm of the foot's height, the nearest one;
/// none of body `not_this`.
[[nodiscard]] std::optional<Support> support_under(const std::vector<Support>& supports, const Eigen::Vector3d& foot,
                                                   std::optional<std::size_t> not_this = std::nullopt);

/// The middle of the underside of a box.
[[nodiscard]] inline Eigen::Vector3d foot_of(const Eigen::AlignedBox3d& box) {
  return {box.center().x(), box.center().y(), box.min().z()};
}

}  // namespace amiss::sim
