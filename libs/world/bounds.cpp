#include "world/bounds.hpp"

#include <type_traits>

namespace amiss::world {
namespace {

/// Corners of a box around the origin.
Eigen::AlignedBox3d moved_box(const Eigen::Vector3d& half, const Eigen::Isometry3d& T) {
  const Eigen::Vector3d reach = T.linear().cwiseAbs() * half;
  return {T.translation() - reach, T.translation() + reach};
}

/// Two discs at +-length/2 along the axis: a disc of radius r and unit axis a reaches r sqrt(1 - a_i^2) along i.
Eigen::AlignedBox3d moved_cylinder(const Cylinder& cylinder, const Eigen::Isometry3d& T) {
  const Eigen::Vector3d axis = T.linear().col(2);
  const Eigen::Vector3d rim = (1.0 - axis.array().square()).max(0.0).sqrt() * cylinder.radius;
  const Eigen::Vector3d reach = axis.cwiseAbs() * (cylinder.length / 2.0) + rim;
  return {T.translation() - reach, T.translation() + reach};
}

Eigen::AlignedBox3d moved_plane(const Plane& plane, const Eigen::Isometry3d& T) {
  const Eigen::Quaterniond R = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), plane.normal);
  return moved_box({plane.size.x() / 2.0, plane.size.y() / 2.0, 0.0}, T * Eigen::Isometry3d(R));
}

Eigen::AlignedBox3d moved_mesh(const MeshInstance& instance, const Eigen::Isometry3d& T) {
  const Eigen::Matrix3f linear = (T.linear() * instance.scale.asDiagonal()).cast<float>();
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& vertex : instance.mesh->vertices) box.extend(linear * vertex);
  if (box.isEmpty()) return {};
  return Eigen::AlignedBox3d(box.cast<double>()).translate(T.translation());
}

}  // namespace

Eigen::AlignedBox3d bounds(const Geometry& geometry, const Eigen::Isometry3d& T) {
  return std::visit(
      [&](const auto& shape) -> Eigen::AlignedBox3d {
        using Kind = std::decay_t<decltype(shape)>;
        if constexpr (std::is_same_v<Kind, Box>) return moved_box(shape.size / 2.0, T);
        if constexpr (std::is_same_v<Kind, Cylinder>) return moved_cylinder(shape, T);
        if constexpr (std::is_same_v<Kind, Plane>) return moved_plane(shape, T);
        if constexpr (std::is_same_v<Kind, MeshInstance>) return moved_mesh(shape, T);
        if constexpr (std::is_same_v<Kind, Sphere>) {
          const Eigen::Vector3d reach = Eigen::Vector3d::Constant(shape.radius);
          return {T.translation() - reach, T.translation() + reach};
        }
      },
      geometry);
}

Eigen::AlignedBox3d bounds(const std::vector<Shape>& shapes) {
  Eigen::AlignedBox3d box;
  for (const Shape& shape : shapes) box.extend(bounds(shape.geometry, shape.T_body_shape));
  return box;
}

Eigen::AlignedBox3d bounds_in_world(const Body& body) {
  Eigen::AlignedBox3d box;
  for (const Shape& shape : body.collisions.empty() ? body.visuals : body.collisions) {
    box.extend(bounds(shape.geometry, body.pose.T * shape.T_body_shape));
  }
  return box;
}

}  // namespace amiss::world
