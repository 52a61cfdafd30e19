#include "mapping/surface_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "mapping/internal/marching_cubes.hpp"

namespace amiss::mapping {
namespace {

constexpr int kGrid = kBlockEdge + 1;  // corners of a block's cubes along an edge
constexpr float kUnseen = std::numeric_limits<float>::quiet_NaN();

/// Distances and colours at the 9 x 9 x 9 corners of the cubes of one block.
struct Corners {
  std::array<float, kGrid * kGrid * kGrid> distance_m;
  std::array<Rgb, kGrid * kGrid * kGrid> colour;

  static std::size_t index(int x, int y, int z) { return static_cast<std::size_t>((z * kGrid + y) * kGrid + x); }
};

class Mesher {
 public:
  Mesher(const SurfaceMap& map, double min_weight) : map_(map), min_weight_(static_cast<float>(min_weight)) {}

  TriangleMesh<Map> mesh() {
    std::vector<BlockKey> keys;
    for (std::uint32_t slot = 0; slot < map_.values().blocks().size(); ++slot) {
      // A cube belongs to the block of its low corner, so a surface in one block may need cubes of seven others.
      if (map_.surface(slot) == nullptr) continue;
      const BlockKey k = map_.values().blocks()[slot].key;
      for (int i = 0; i < 8; ++i) keys.push_back({k.x - (i & 1), k.y - ((i >> 1) & 1), k.z - (i >> 2)});
    }
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    for (const BlockKey& key : keys) add_block(key);
    for (Eigen::Vector3f& n : mesh_.vertices.normals) n.normalize();
    return std::move(mesh_);
  }

 private:
  void add_block(BlockKey key) {
    if (!read_corners(key)) return;
    for (int z = 0; z < kBlockEdge; ++z) {
      for (int y = 0; y < kBlockEdge; ++y) {
        for (int x = 0; x < kBlockEdge; ++x) add_cube(key, x, y, z);
      }
    }
  }

  /// False where all is on one side.
  bool read_corners(BlockKey key) {
    bool inside = false;
    for (int part = 0; part < 8; ++part) {
      const int dx = part & 1, dy = (part >> 1) & 1, dz = part >> 2;
      const std::uint32_t slot = map_.values().find({key.x + dx, key.y + dy, key.z + dz});
      const auto last = [](int d) { return d == 1 ? 1 : kBlockEdge; };
      for (int z = 0; z < last(dz); ++z) {
        for (int y = 0; y < last(dy); ++y) {
          for (int x = 0; x < last(dx); ++x) {
            const std::size_t at = Corners::index(x + dx * kBlockEdge, y + dy * kBlockEdge, z + dz * kBlockEdge);
            read_corner(slot, static_cast<std::size_t>((z * kBlockEdge + y) * kBlockEdge + x), at);
            inside |= corners_.distance_m[at] < 0.0f;
          }
        }
      }
    }
    return inside;
  }

  void read_corner(std::uint32_t slot, std::size_t in_block, std::size_t at) {
    corners_.distance_m[at] = kUnseen;
    if (slot == VoxelBlocks::kNone) return;
    if (const SurfaceVoxels* voxels = map_.surface(slot)) {
      const float weight = voxels->weight[in_block];
      if (weight <= 0.0f || weight < min_weight_) return;
      corners_.distance_m[at] = voxels->distance_m[in_block];
      corners_.colour[at] = voxels->colour[in_block];
    }  // free space alone is never beside a surface without a jump
  }

  void add_cube(BlockKey key, int x, int y, int z) {
    std::size_t at[8];
    unsigned pattern = 0;
    float low = std::numeric_limits<float>::max();
    bool seen = true;
    for (int c = 0; c < 8; ++c) {
      at[c] = Corners::index(x + (c & 1), y + ((c >> 1) & 1), z + (c >> 2));
      const float d = corners_.distance_m[at[c]];
      seen &= !std::isnan(d);
      low = std::min(low, d);
      pattern |= (d < 0.0f ? 1U : 0U) << c;
    }
    if (!seen || pattern == 0 || pattern == 255) return;
    const auto truncation = static_cast<float>(map_.params().truncation_m());
    for (int e = 0; e < kCubeEdges; ++e) {
      const CubeEdge edge = cube_edge(e);
      const float a = corners_.distance_m[at[edge.corner]], b = corners_.distance_m[at[edge.corner | (1 << edge.axis)]];
      if ((a < 0.0f) != (b < 0.0f) && std::abs(a - b) > truncation) return;
    }
    const Voxel origin{key.x * kBlockEdge + x, key.y * kBlockEdge + y, key.z * kBlockEdge + z};
    for (const auto& triangle : cube_triangles(pattern)) {
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t i = 0; i < 3; ++i) corners[i] = vertex(origin, cube_edge(triangle[i]), at);
      add_triangle(corners);
    }
  }

  /// The vertex on an edge of a cube, shared by the cubes around it.
  std::uint32_t vertex(Voxel origin, CubeEdge edge, const std::size_t (&at)[8]) {
    const Voxel v{origin.x + (edge.corner & 1), origin.y + ((edge.corner >> 1) & 1), origin.z + (edge.corner >> 2)};
    const auto place = [](int i) { return static_cast<std::uint64_t>(i + kVoxelLimit + 1); };
    const std::uint64_t name =
        (((place(v.x) << 20 | place(v.y)) << 20 | place(v.z)) << 2) | static_cast<std::uint64_t>(edge.axis);
    const auto [found, added] = vertices_.try_emplace(name, static_cast<std::uint32_t>(mesh_.vertices.points.size()));
    if (!added) return found->second;
    const std::size_t from = at[edge.corner], to = at[edge.corner | (1 << edge.axis)];
    const float a = corners_.distance_m[from], b = corners_.distance_m[to], part = a / (a - b);
    Eigen::Vector3d p = map_.centre_of(v);
    p[edge.axis] += static_cast<double>(part) * map_.params().voxel_m;
    mesh_.vertices.points.push_back(p.cast<float>());
    mesh_.vertices.colours.push_back(corners_.colour[part < 0.5f ? from : to]);
    mesh_.vertices.normals.emplace_back(Eigen::Vector3f::Zero());
    return found->second;
  }

  void add_triangle(const std::array<std::uint32_t, 3>& corners) {
    const auto& p = mesh_.vertices.points;
    const Eigen::Vector3f twice_area = (p[corners[1]] - p[corners[0]]).cross(p[corners[2]] - p[corners[0]]);
    for (const std::uint32_t i : corners) mesh_.vertices.normals[i] += twice_area;
    mesh_.triangles.push_back(corners);
  }

  const SurfaceMap& map_;
  float min_weight_;
  Corners corners_{};
  std::unordered_map<std::uint64_t, std::uint32_t> vertices_;
  TriangleMesh<Map> mesh_;
};

}  // namespace

TriangleMesh<Map> surface_mesh(const SurfaceMap& map, double min_weight) { return Mesher(map, min_weight).mesh(); }

Cloud<Map> surface_cloud(const TriangleMesh<Map>& mesh, double voxel_m) {
  const Cloud<Map>& in = mesh.vertices;
  std::vector<std::pair<Voxel, std::uint32_t>> order;
  order.reserve(in.points.size());
  for (std::uint32_t i = 0; i < in.points.size(); ++i) {
    const Eigen::Vector3d v = (in.points[i].cast<double>() / voxel_m).array().floor();
    order.push_back({{static_cast<int>(v.x()), static_cast<int>(v.y()), static_cast<int>(v.z())}, i});
  }
  std::sort(order.begin(), order.end());
  Cloud<Map> cloud;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    Eigen::Vector3f point = Eigen::Vector3f::Zero(), normal = point, colour = point;
    for (; end < order.size() && order[end].first == order[begin].first; ++end) {
      const std::uint32_t i = order[end].second;
      point += in.points[i];
      normal += in.normals[i];
      colour += Eigen::Vector3f(in.colours[i].r, in.colours[i].g, in.colours[i].b);
    }
    const float n = static_cast<float>(end - begin);
    cloud.points.push_back(point / n);
    cloud.normals.push_back(normal.normalized());
    const auto mean = [&](float sum) { return static_cast<std::uint8_t>(sum / n + 0.5f); };
    cloud.colours.push_back({mean(colour.x()), mean(colour.y()), mean(colour.z())});
  }
  return cloud;
}

}  // namespace amiss::mapping
