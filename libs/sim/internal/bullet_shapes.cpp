#include "sim/internal/bullet_shapes.hpp"

#include <LinearMath/btConvexHullComputer.h>

#include <set>

namespace amiss::sim::internal {
namespace {

constexpr double kHullMargin_m = 0.0005;
constexpr int kMaxHullVertices = 96;
constexpr double kThin_m = 0.002;  // a plane that moves

/// Directions that cover the sphere evenly (Fibonacci lattice).
std::vector<Eigen::Vector3d> even_directions(int count) {
  std::vector<Eigen::Vector3d> out;
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double r = std::sqrt(1.0 - z * z);
    out.emplace_back(r * std::cos(golden * i), r * std::sin(golden * i), z);
  }
  for (int axis = 0; axis < 3; ++axis) {
    out.push_back(Eigen::Vector3d::Unit(axis));
    out.push_back(-Eigen::Vector3d::Unit(axis));
  }
  return out;
}

/// The vertices that are farthest in one of many directions: a hull of bounded size, at most a fraction of a
/// millimetre smaller for things that lie on a floor.
std::vector<btVector3> support_vertices(const btAlignedObjectArray<btVector3>& vertices) {
  std::set<int> chosen;
  for (const Eigen::Vector3d& direction : even_directions(2 * kMaxHullVertices)) {
    int best = 0;
    for (int i = 1; i < vertices.size(); ++i) {
      if (vertices[i].dot(to_bullet(direction)) > vertices[best].dot(to_bullet(direction))) best = i;
    }
    chosen.insert(best);
  }
  std::vector<btVector3> out;
  for (const int i : chosen) out.push_back(vertices[i]);
  return out;
}

std::vector<btVector3> hull_vertices(const std::vector<btVector3>& points) {
  btConvexHullComputer computer;
  computer.compute(&points[0].x(), sizeof(btVector3), static_cast<int>(points.size()), 0, 0);
  if (computer.vertices.size() > kMaxHullVertices) return support_vertices(computer.vertices);
  std::vector<btVector3> out;
  for (int i = 0; i < computer.vertices.size(); ++i) out.push_back(computer.vertices[i]);
  return out.empty() ? points : out;
}

std::vector<btVector3> boundary_points(const btConvexShape& shape) {
  std::vector<btVector3> points;
  for (const Eigen::Vector3d& direction : even_directions(200)) {
    points.push_back(shape.localGetSupportingVertex(to_bullet(direction)));
  }
  return points;
}

}  // namespace

btTransform to_bullet(const Eigen::Isometry3d& T) {
  const Eigen::Matrix3d R = T.rotation();
  return btTransform(btMatrix3x3(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)),
                     to_bullet(Eigen::Vector3d(T.translation())));
}

Eigen::Isometry3d from_bullet(const btTransform& T) {
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row) out.linear().row(row) = from_bullet(T.getBasis()[row]).transpose();
  out.translation() = from_bullet(T.getOrigin());
  return out;
}

struct BulletShapes::Tree {
  std::shared_ptr<const world::Mesh> mesh;
  std::vector<int> indices;
  std::unique_ptr<btTriangleIndexVertexArray> triangles;
  std::unique_ptr<btBvhTriangleMeshShape> shape;
};

std::shared_ptr<btCollisionShape> BulletShapes::triangles(const world::MeshInstance& instance) {
  if (!instance.mesh || instance.mesh->indices.size() < 3) return nullptr;
  std::shared_ptr<Tree>& tree = trees_[instance.mesh.get()];
  if (!tree) {
    tree = std::make_shared<Tree>();
    tree->mesh = instance.mesh;
    tree->indices.assign(instance.mesh->indices.begin(), instance.mesh->indices.end());
    btIndexedMesh part;
    part.m_numTriangles = static_cast<int>(tree->indices.size() / 3);
    part.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(tree->indices.data());
    part.m_triangleIndexStride = 3 * sizeof(int);
    part.m_numVertices = static_cast<int>(tree->mesh->vertices.size());
    part.m_vertexBase = reinterpret_cast<const unsigned char*>(tree->mesh->vertices.data());
    part.m_vertexStride = sizeof(Eigen::Vector3f);
    part.m_vertexType = PHY_FLOAT;
    tree->triangles = std::make_unique<btTriangleIndexVertexArray>();
    tree->triangles->addIndexedMesh(part, PHY_INTEGER);
    tree->shape = std::make_unique<btBvhTriangleMeshShape>(tree->triangles.get(), true);
  }
  auto* scaled = new btScaledBvhTriangleMeshShape(tree->shape.get(), to_bullet(instance.scale));
  return {scaled, [tree](btScaledBvhTriangleMeshShape* shape) { delete shape; }};
}

std::shared_ptr<btConvexShape> BulletShapes::hull(const world::MeshInstance& instance) {
  if (!instance.mesh || instance.mesh->vertices.empty()) return nullptr;
  const Eigen::Vector3d& scale = instance.scale;
  std::shared_ptr<btConvexShape>& shape = hulls_[{instance.mesh.get(), scale.x(), scale.y(), scale.z()}];
  if (!shape) {
    kept_.push_back(instance.mesh);
    std::vector<btVector3> points;
    for (const Eigen::Vector3f& v : instance.mesh->vertices) {
      points.push_back(to_bullet(Eigen::Vector3d(v.cast<double>().cwiseProduct(scale))));
    }
    auto hull = std::make_shared<btConvexHullShape>();
    for (const btVector3& v : hull_vertices(points)) hull->addPoint(v, false);
    hull->recalcLocalAabb();
    hull->setMargin(kHullMargin_m);
    shape = hull;
  }
  return shape;
}

std::shared_ptr<btCollisionShape> BulletShapes::fixed(const world::Geometry& geometry) {
  if (const auto* plane = std::get_if<world::Plane>(&geometry)) {
    return std::make_shared<btStaticPlaneShape>(to_bullet(Eigen::Vector3d(plane->normal.normalized())), 0.0);
  }
  if (const auto* mesh = std::get_if<world::MeshInstance>(&geometry)) return triangles(*mesh);
  return moving(geometry);
}

std::shared_ptr<btConvexShape> BulletShapes::moving(const world::Geometry& geometry) {
  if (const auto* box = std::get_if<world::Box>(&geometry)) {
    return std::make_shared<btBoxShape>(to_bullet(Eigen::Vector3d(0.5 * box->size)));
  }
  if (const auto* cylinder = std::get_if<world::Cylinder>(&geometry)) {
    return std::make_shared<btCylinderShapeZ>(btVector3(cylinder->radius, cylinder->radius, 0.5 * cylinder->length));
  }
  if (const auto* sphere = std::get_if<world::Sphere>(&geometry)) {
    return std::make_shared<btSphereShape>(sphere->radius);
  }
  if (const auto* plane = std::get_if<world::Plane>(&geometry)) {
    const Eigen::Vector3d n = plane->normal.cwiseAbs();
    Eigen::Vector3d half(0.5 * plane->size.x(), 0.5 * plane->size.y(), kThin_m);
    if (n.x() > n.z()) half = Eigen::Vector3d(kThin_m, half.y(), half.x());
    if (n.y() > n.z()) half = Eigen::Vector3d(half.x(), kThin_m, half.y());
    return std::make_shared<btBoxShape>(to_bullet(half));
  }
  return hull(std::get<world::MeshInstance>(geometry));
}

Bulk bulk_of(const btConvexShape& shape) {
  const std::vector<btVector3> points = boundary_points(shape);
  btConvexHullComputer computer;
  computer.compute(&points[0].x(), sizeof(btVector3), static_cast<int>(points.size()), 0, 0);
  Eigen::Vector3d inside = Eigen::Vector3d::Zero();
  for (const btVector3& point : points) inside += from_bullet(point) / static_cast<double>(points.size());
  Bulk bulk{0.0, Eigen::Vector3d::Zero()};
  for (int f = 0; f < computer.faces.size(); ++f) {
    const btConvexHullComputer::Edge* first = &computer.edges[computer.faces[f]];
    const Eigen::Vector3d a = from_bullet(computer.vertices[first->getSourceVertex()]) - inside;
    for (const auto* edge = first->getNextEdgeOfFace(); edge->getTargetVertex() != first->getSourceVertex();
         edge = edge->getNextEdgeOfFace()) {
      const Eigen::Vector3d b = from_bullet(computer.vertices[edge->getSourceVertex()]) - inside;
      const Eigen::Vector3d c = from_bullet(computer.vertices[edge->getTargetVertex()]) - inside;
      const double sixfold = std::abs(a.dot(b.cross(c)));
      bulk.volume_m3 += sixfold / 6.0;
      bulk.centre += sixfold / 24.0 * (a + b + c);
    }
  }
  if (bulk.volume_m3 > 0.0) bulk.centre /= bulk.volume_m3;
  bulk.centre += inside;
  return bulk;
}

}  // namespace amiss::sim::internal
