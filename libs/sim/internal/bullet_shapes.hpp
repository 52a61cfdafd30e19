// Geometry -> Bullet's collision shapes. Triangle trees of static meshes and hulls of moving ones are built once for
// each mesh (and scale) and live as long as this.
#pragma once

#include <btBulletCollisionCommon.h>

#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "world/world.hpp"

namespace amiss::sim::internal {

[[nodiscard]] inline btVector3 to_bullet(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
[[nodiscard]] inline Eigen::Vector3d from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
[[nodiscard]] btTransform to_bullet(const Eigen::Isometry3d& T);
[[nodiscard]] Eigen::Isometry3d from_bullet(const btTransform& T);

class BulletShapes {
 public:
  /// nullptr where there is nothing to collide with (an empty mesh).
  [[nodiscard]] std::shared_ptr<btCollisionShape> fixed(const world::Geometry& geometry);
  /// Convex; a plane becomes a thin box.
  [[nodiscard]] std::shared_ptr<btConvexShape> moving(const world::Geometry& geometry);

 private:
  struct Tree;
  using HullKey = std::tuple<const world::Mesh*, double, double, double>;

  [[nodiscard]] std::shared_ptr<btCollisionShape> triangles(const world::MeshInstance& instance);
  [[nodiscard]] std::shared_ptr<btConvexShape> hull(const world::MeshInstance& instance);

  std::map<const world::Mesh*, std::shared_ptr<Tree>> trees_;
  std::map<HullKey, std::shared_ptr<btConvexShape>> hulls_;
  std::vector<std::shared_ptr<const world::Mesh>> kept_;  // keeps the keys unique
};

/// Volume [m^3] and centre of a convex shape.
struct Bulk {
  double volume_m3;
  Eigen::Vector3d centre;
};
[[nodiscard]] Bulk bulk_of(const btConvexShape& shape);

}  // namespace amiss::sim::internal
