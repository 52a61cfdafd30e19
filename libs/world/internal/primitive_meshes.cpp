#include "world/internal/primitive_meshes.hpp"

#include <numbers>
#include <utility>

namespace amiss::world {
namespace {

constexpr int kAround = 24, kRings = 12;  // ring kRings / 2 is the equator

/// A sphere of unit normals, its vertices placed by `place(normal, is_upper)`. The equator stands twice, so that the
/// halves can be drawn apart.
template <class Place, class NormalOf>
std::shared_ptr<const Mesh> rounded(Place place, NormalOf normal_of) {
  Mesh mesh;
  for (int ring = 0; ring <= kRings + 1; ++ring) {
    const bool upper = ring <= kRings / 2;
    const double polar = std::numbers::pi * (upper ? ring : ring - 1) / kRings;
    for (int step = 0; step <= kAround; ++step) {
      const double around = 2.0 * std::numbers::pi * step / kAround;
      const Eigen::Vector3d n(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar));
      mesh.vertices.push_back(place(n, upper).template cast<float>());
      mesh.normals.push_back(normal_of(n).normalized().template cast<float>());
    }
  }
  const auto index = [](int ring, int step) { return static_cast<std::uint32_t>(ring * (kAround + 1) + step); };
  for (int ring = 0; ring <= kRings; ++ring) {
    for (int step = 0; step < kAround; ++step) {
      for (const std::uint32_t i : {index(ring, step), index(ring + 1, step), index(ring + 1, step + 1),
                                    index(ring, step), index(ring + 1, step + 1), index(ring, step + 1)}) {
        mesh.indices.push_back(i);
      }
    }
  }
  return std::make_shared<const Mesh>(std::move(mesh));
}

}  // namespace

std::shared_ptr<const Mesh> capsule_mesh(double radius_m, double length_m) {
  return rounded(
      [&](const Eigen::Vector3d& n, bool upper) {
        return Eigen::Vector3d(radius_m * n + Eigen::Vector3d(0.0, 0.0, upper ? length_m / 2.0 : -length_m / 2.0));
      },
      [](const Eigen::Vector3d& n) { return n; });
}

std::shared_ptr<const Mesh> ellipsoid_mesh(const Eigen::Vector3d& radii_m) {
  return rounded([&](const Eigen::Vector3d& n, bool) { return Eigen::Vector3d(radii_m.cwiseProduct(n)); },
                 [&](const Eigen::Vector3d& n) { return Eigen::Vector3d(n.cwiseQuotient(radii_m)); });
}

std::shared_ptr<const Mesh> inside_out(const Mesh& mesh) {
  Mesh turned = mesh;
  for (std::size_t i = 0; i + 2 < turned.indices.size(); i += 3)
    std::swap(turned.indices[i + 1], turned.indices[i + 2]);
  return std::make_shared<const Mesh>(std::move(turned));
}

Eigen::Vector3d centre_of_bounds(const Mesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& vertex : mesh.vertices) box.extend(vertex);
  return box.isEmpty() ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : Eigen::Vector3d(box.center().cast<double>());
}

}  // namespace amiss::world
