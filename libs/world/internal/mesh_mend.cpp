#include "world/internal/mesh_mend.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace amiss::world {
namespace {

bool look_the_same(const MeshPart& a, const MeshPart& b) {
  return a.material.texture == b.material.texture && a.material.diffuse == b.material.diffuse &&
         a.material.alpha == b.material.alpha && a.material.specular == b.material.specular &&
         a.mesh->uvs.empty() == b.mesh->uvs.empty() && a.mesh->colours.empty() == b.mesh->colours.empty();
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

Mesh joined(const std::vector<const Mesh*>& meshes) {
  Mesh all;
  for (const Mesh* mesh : meshes) {
    const auto base = static_cast<std::uint32_t>(all.vertices.size());
    append(all.vertices, mesh->vertices);
    append(all.normals, mesh->normals);
    append(all.uvs, mesh->uvs);
    append(all.colours, mesh->colours);
    for (const std::uint32_t i : mesh->indices) all.indices.push_back(base + i);
  }
  return all;
}

Eigen::Vector3f doubled_area(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const Eigen::Vector3f& a = mesh.vertices[t[0]];
  return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
}

}  // namespace

void mend_mesh(Mesh& mesh) {
  std::vector<Eigen::Vector3f> from_faces(mesh.vertices.size(), Eigen::Vector3f::Zero());
  std::vector<std::uint32_t> kept;
  kept.reserve(mesh.indices.size());
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    std::array<std::uint32_t, 3> t = {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
    if (std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return v >= mesh.vertices.size(); })) continue;
    Eigen::Vector3f face = doubled_area(mesh, t);
    if (!face.allFinite() || face.squaredNorm() <= 0.0F) continue;
    const Eigen::Vector3f given = mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]];
    if (given.allFinite() && given.dot(face) < 0.0F) {
      std::swap(t[1], t[2]);
      face = -face;
    }
    for (const std::uint32_t v : t) {
      from_faces[v] += face;
      kept.push_back(v);
    }
  }
  mesh.indices = std::move(kept);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const bool given = mesh.normals[v].allFinite() && mesh.normals[v].squaredNorm() > 1e-12F;
    const Eigen::Vector3f normal = given ? mesh.normals[v] : from_faces[v];
    mesh.normals[v] =
        normal.squaredNorm() > 0.0F ? Eigen::Vector3f(normal.normalized()) : Eigen::Vector3f(0.0F, 0.0F, 1.0F);
    if (!mesh.vertices[v].allFinite()) mesh.vertices[v].setZero();
  }
}

std::vector<MeshPart> merged_by_material(const std::vector<MeshPart>& parts) {
  std::vector<MeshPart> merged;
  std::vector<std::vector<const Mesh*>> members;
  for (const MeshPart& part : parts) {
    const auto same =
        std::find_if(merged.begin(), merged.end(), [&](const MeshPart& other) { return look_the_same(part, other); });
    if (same == merged.end()) {
      merged.push_back(part);
      members.push_back({part.mesh.get()});
    } else {
      members[static_cast<std::size_t>(same - merged.begin())].push_back(part.mesh.get());
    }
  }
  for (std::size_t i = 0; i < merged.size(); ++i) {
    if (members[i].size() > 1) merged[i].mesh = std::make_shared<const Mesh>(joined(members[i]));
  }
  return merged;
}

}  // namespace amiss::world
