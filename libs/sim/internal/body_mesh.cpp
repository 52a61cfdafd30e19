#include "sim/internal/body_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "sim/internal/triangles.hpp"

namespace amiss::sim::internal {
namespace {

constexpr double kCell = 2.0;             // edge of the cells whose shapes share a batch [m]
constexpr float kOpaque = 0.99F;          // as in world::Material
constexpr float kMirroredByShiny = 0.9F;  // share of the light that a fully specular surface sends elsewhere

struct Piece {
  Triangles triangles;
  const world::Shape* shape;
};

/// Pieces with the same key are drawn together.
using Key = std::tuple<bool, std::size_t, bool, int, int, int>;

int cell(double x) { return static_cast<int>(std::floor(x / kCell)); }

std::uint8_t to_byte(float share) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0F, 1.0F) * 255.0F));
}

std::int16_t to_short(float x) { return static_cast<std::int16_t>(std::lround(std::clamp(x, -1.0F, 1.0F) * 32767.0F)); }

std::array<std::uint8_t, 4> colour_of(const Piece& piece, std::size_t vertex) {
  const world::Material& material = piece.shape->material;
  Eigen::Vector3f c = material.diffuse;
  if (!piece.triangles.colours.empty()) {
    const Rgb own = piece.triangles.colours[vertex];
    c = c.cwiseProduct(Eigen::Vector3f(own.r, own.g, own.b) / 255.0F);
  }
  return {to_byte(c.x()), to_byte(c.y()), to_byte(c.z()), to_byte(material.alpha)};
}

void append(BodyMesh& mesh, Batch& batch, const Piece& piece) {
  const Eigen::Isometry3f T = piece.shape->T_body_shape.cast<float>();
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  const std::uint8_t matt = to_byte(1.0F - kMirroredByShiny * std::clamp(piece.shape->material.specular, 0.0F, 1.0F));
  const Triangles& t = piece.triangles;
  for (std::size_t i = 0; i < t.positions.size(); ++i) {
    const Eigen::Vector3f p = T * t.positions[i], n = T.linear() * t.normals[i];
    batch.box.extend(p);
    mesh.vertices.push_back({{p.x(), p.y(), p.z()},
                             {to_short(n.x()), to_short(n.y()), to_short(n.z()), 0},
                             {t.uvs[i].x(), t.uvs[i].y()},
                             colour_of(piece, i),
                             {matt, 0, 0, 0}});
  }
  for (const std::uint32_t index : t.indices) mesh.indices.push_back(base + index);
}

}  // namespace

BodyMesh body_mesh(const world::Body& body) {
  std::map<const world::Texture*, std::size_t> order;  // of first use: addresses would not be the same in every run
  std::map<Key, std::vector<Piece>> groups;
  for (const world::Shape& shape : body.visuals) {
    Piece piece{triangulate(shape.geometry), &shape};
    if (piece.triangles.indices.empty()) continue;
    Eigen::AlignedBox3f box;
    for (const auto& p : piece.triangles.positions) box.extend(shape.T_body_shape.cast<float>() * p);
    const Eigen::Vector3d middle = box.center().cast<double>();
    const world::Texture* texture = shape.material.texture.get();
    const std::size_t rank = texture == nullptr ? 0 : order.try_emplace(texture, order.size() + 1).first->second;
    const Key key{shape.material.alpha < kOpaque,
                  rank,
                  !piece.triangles.closed,
                  cell(middle.x()),
                  cell(middle.y()),
                  cell(middle.z())};
    groups[key].push_back(std::move(piece));
  }
  BodyMesh mesh;
  for (const auto& [key, pieces] : groups) {
    Batch batch;
    batch.transparent = std::get<0>(key);
    batch.closed = !std::get<2>(key);
    batch.texture = pieces.front().shape->material.texture;
    batch.first_index = static_cast<std::uint32_t>(mesh.indices.size());
    for (const Piece& piece : pieces) append(mesh, batch, piece);
    batch.index_count = static_cast<std::uint32_t>(mesh.indices.size()) - batch.first_index;
    mesh.batches.push_back(std::move(batch));
  }
  return mesh;
}

}  // namespace amiss::sim::internal
