#include "sim/internal/triangles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/internal/closed_mesh.hpp"

namespace amiss::sim::internal {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

std::uint32_t add_vertex(Triangles& out, const Vector3f& position, const Vector3f& normal, const Vector2f& uv) {
  out.positions.push_back(position);
  out.normals.push_back(normal);
  out.uvs.push_back(uv);
  return static_cast<std::uint32_t>(out.positions.size() - 1);
}

void add_triangle(Triangles& out, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  out.indices.insert(out.indices.end(), {a, b, c});
}

/// Corners centre +- right +- up, seen from where the normal points to.
void add_quad(Triangles& out, const Vector3f& centre, const Vector3f& right, const Vector3f& up) {
  const Vector3f normal = right.cross(up).normalized();
  const auto a = add_vertex(out, centre - right - up, normal, {0, 0});
  const auto b = add_vertex(out, centre + right - up, normal, {1, 0});
  const auto c = add_vertex(out, centre + right + up, normal, {1, 1});
  const auto d = add_vertex(out, centre - right + up, normal, {0, 1});
  add_triangle(out, a, b, c);
  add_triangle(out, a, c, d);
}

/// Any two unit vectors that make a right-handed frame with the normal.
std::pair<Vector3f, Vector3f> tangents(const Vector3f& normal) {
  const Vector3f helper = std::abs(normal.z()) > 0.99F ? Vector3f::UnitY() : Vector3f::UnitZ();
  const Vector3f right = helper.cross(normal).normalized();
  return {right, normal.cross(right)};
}

Triangles triangles_of(const world::Box& box) {
  Triangles out;
  const Vector3f half = box.size.cast<float>() / 2.0F;
  for (const Vector3f& normal : {Vector3f(1, 0, 0), Vector3f(-1, 0, 0), Vector3f(0, 1, 0), Vector3f(0, -1, 0),
                                 Vector3f(0, 0, 1), Vector3f(0, 0, -1)}) {
    const auto [right, up] = tangents(normal);
    add_quad(out, normal.cwiseProduct(half), right.cwiseProduct(half), up.cwiseProduct(half));
  }
  return out;
}

int segments_of(double radius) { return std::clamp(static_cast<int>(radius * 200.0), 12, 40); }

Vector3f round_the_axis(int step, int segments) {
  const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(step) / static_cast<float>(segments);
  return {std::cos(angle), std::sin(angle), 0.0F};
}

void add_disc(Triangles& out, float radius, float z, int segments) {
  const float side = z > 0.0F ? 1.0F : -1.0F;
  const auto middle = add_vertex(out, {0, 0, z}, {0, 0, side}, {0.5F, 0.5F});
  for (int i = 0; i <= segments; ++i) {
    const Vector3f d = round_the_axis(side > 0.0F ? i : -i, segments);
    const auto here = add_vertex(out, d * radius + Vector3f(0, 0, z), {0, 0, side},
                                 Vector2f(0.5F, 0.5F) + 0.5F * Vector2f(d.x(), side * d.y()));
    if (i > 0) add_triangle(out, middle, here - 1, here);
  }
}

Triangles triangles_of(const world::Cylinder& cylinder) {
  Triangles out;
  const int segments = segments_of(cylinder.radius);
  const auto radius = static_cast<float>(cylinder.radius);
  const auto half = static_cast<float>(cylinder.length / 2.0);
  for (int i = 0; i <= segments; ++i) {
    const Vector3f d = round_the_axis(i, segments);
    const float u = static_cast<float>(i) / static_cast<float>(segments);
    const auto low = add_vertex(out, d * radius - Vector3f(0, 0, half), d, {u, 0});
    const auto high = add_vertex(out, d * radius + Vector3f(0, 0, half), d, {u, 1});
    if (i == 0) continue;
    add_triangle(out, low - 2, low, high);
    add_triangle(out, low - 2, high, high - 2);
  }
  add_disc(out, radius, half, segments);
  add_disc(out, radius, -half, segments);
  return out;
}

Triangles triangles_of(const world::Sphere& sphere) {
  Triangles out;
  const int segments = segments_of(sphere.radius), rings = segments / 2;
  const auto radius = static_cast<float>(sphere.radius);
  for (int ring = 0; ring <= rings; ++ring) {
    const float v = static_cast<float>(ring) / static_cast<float>(rings);
    const float tilt = (v - 0.5F) * std::numbers::pi_v<float>;
    for (int i = 0; i <= segments; ++i) {
      const Vector3f normal = round_the_axis(i, segments) * std::cos(tilt) + Vector3f(0, 0, std::sin(tilt));
      const float u = static_cast<float>(i) / static_cast<float>(segments);
      const auto here = add_vertex(out, normal * radius, normal, {u, v});
      if (ring == 0 || i == 0) continue;
      const auto below = here - static_cast<std::uint32_t>(segments) - 1;
      if (ring > 1) add_triangle(out, below - 1, below, here);
      if (ring < rings) add_triangle(out, below - 1, here, here - 1);
    }
  }
  return out;
}

Triangles triangles_of(const world::Plane& plane) {
  Triangles out;
  const auto [right, up] = tangents(plane.normal.cast<float>().normalized());
  add_quad(out, Vector3f::Zero(), right * static_cast<float>(plane.size.x() / 2.0),
           up * static_cast<float>(plane.size.y() / 2.0));
  out.closed = false;
  return out;
}

/// For meshes made in memory; those from files have theirs.
std::vector<Vector3f> smooth_normals(const Triangles& t) {
  std::vector<Vector3f> normals(t.positions.size(), Vector3f::Zero());
  for (std::size_t i = 0; i + 2 < t.indices.size(); i += 3) {
    const auto a = t.indices[i], b = t.indices[i + 1], c = t.indices[i + 2];
    const Vector3f area = (t.positions[b] - t.positions[a]).cross(t.positions[c] - t.positions[a]);
    for (const auto corner : {a, b, c}) normals[corner] += area;
  }
  for (auto& normal : normals) normal.normalize();
  return normals;
}

Triangles triangles_of(const world::MeshInstance& instance) {
  Triangles out;
  const world::Mesh& mesh = *instance.mesh;
  const Vector3f scale = instance.scale.cast<float>();
  for (const auto& vertex : mesh.vertices) out.positions.push_back(vertex.cwiseProduct(scale));
  for (const auto& normal : mesh.normals) out.normals.push_back(normal.cwiseQuotient(scale).normalized());
  out.uvs = mesh.uvs;
  out.uvs.resize(mesh.vertices.size(), Vector2f::Zero());
  if (mesh.colours.size() == mesh.vertices.size()) out.colours = mesh.colours;
  out.indices = mesh.indices;
  if (out.normals.size() != out.positions.size()) out.normals = smooth_normals(out);
  out.closed = is_closed(out.positions, out.indices);
  return out;
}

}  // namespace

Triangles triangulate(const world::Geometry& geometry) {
  return std::visit([](const auto& shape) { return triangles_of(shape); }, geometry);
}

}  // namespace amiss::sim::internal
