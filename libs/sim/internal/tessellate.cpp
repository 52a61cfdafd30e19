#include "sim/internal/tessellate.hpp"

namespace amiss::sim::internal {
namespace {

using Eigen::Vector3d;

void add_quad(std::vector<Triangle>& out, const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  out.push_back({a, b, c});
  out.push_back({a, c, d});
}

std::vector<Triangle> triangles_of(const world::Box& box) {
  std::array<Vector3d, 8> corner;
  for (unsigned i = 0; i < 8; ++i) {
    const Vector3d sign((i & 1U) != 0U ? 0.5 : -0.5, (i & 2U) != 0U ? 0.5 : -0.5, (i & 4U) != 0U ? 0.5 : -0.5);
    corner[i] = sign.cwiseProduct(box.size);
  }
  std::vector<Triangle> out;
  add_quad(out, corner[0], corner[2], corner[3], corner[1]);
  add_quad(out, corner[4], corner[5], corner[7], corner[6]);
  add_quad(out, corner[0], corner[1], corner[5], corner[4]);
  add_quad(out, corner[2], corner[6], corner[7], corner[3]);
  add_quad(out, corner[0], corner[4], corner[6], corner[2]);
  add_quad(out, corner[1], corner[3], corner[7], corner[5]);
  return out;
}

Vector3d on_circle(int facet, double radius, double z) {
  const double angle = 2.0 * std::numbers::pi * facet / kFacets;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

std::vector<Triangle> triangles_of(const world::Cylinder& cylinder) {
  const double top = 0.5 * cylinder.length;
  std::vector<Triangle> out;
  for (int i = 0; i < kFacets; ++i) {
    const Vector3d a = on_circle(i, cylinder.radius, -top), b = on_circle(i + 1, cylinder.radius, -top);
    const Vector3d c = on_circle(i + 1, cylinder.radius, top), d = on_circle(i, cylinder.radius, top);
    add_quad(out, a, b, c, d);
    out.push_back({Vector3d(0, 0, -top), b, a});
    out.push_back({Vector3d(0, 0, top), d, c});
  }
  return out;
}

std::vector<Triangle> triangles_of(const world::Sphere& sphere) {
  const auto ring = [&](int latitude, int facet) {
    const double angle = std::numbers::pi * (2.0 * latitude / kFacets - 0.5);
    return on_circle(facet, sphere.radius * std::cos(angle), sphere.radius * std::sin(angle));
  };
  std::vector<Triangle> out;
  for (int latitude = 0; latitude < kFacets / 2; ++latitude) {
    for (int i = 0; i < kFacets; ++i) {
      add_quad(out, ring(latitude, i), ring(latitude, i + 1), ring(latitude + 1, i + 1), ring(latitude + 1, i));
    }
  }
  return out;
}

std::vector<Triangle> triangles_of(const world::Plane& plane) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), plane.normal);
  const double x = 0.5 * plane.size.x(), y = 0.5 * plane.size.y();
  std::vector<Triangle> out;
  add_quad(out, turn * Vector3d(-x, -y, 0), turn * Vector3d(x, -y, 0), turn * Vector3d(x, y, 0),
           turn * Vector3d(-x, y, 0));
  return out;
}

std::vector<Triangle> triangles_of(const world::MeshInstance& instance) {
  std::vector<Triangle> out;
  if (!instance.mesh) return out;
  const world::Mesh& mesh = *instance.mesh;
  out.reserve(mesh.indices.size() / 3);
  const auto vertex = [&](std::size_t i) -> Vector3d {
    return mesh.vertices[mesh.indices[i]].cast<double>().cwiseProduct(instance.scale);
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) out.push_back({vertex(i), vertex(i + 1), vertex(i + 2)});
  return out;
}

}  // namespace

std::vector<Triangle> tessellate(const world::Geometry& geometry) {
  return std::visit([](const auto& g) { return triangles_of(g); }, geometry);
}

bool is_solid(const world::Geometry& geometry) {
  return !std::holds_alternative<world::MeshInstance>(geometry) && !std::holds_alternative<world::Plane>(geometry);
}

}  // namespace amiss::sim::internal
