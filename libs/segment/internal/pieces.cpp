#include "segment/internal/pieces.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <unordered_map>

#include "segment/internal/ground.hpp"

namespace amiss::segment::internal {

namespace {

constexpr int kNormalReach = 3;       // pixels to each side
constexpr float kNoiseFactor = 1.5F;  // of the depth noise that the ground may show
constexpr std::size_t kSpeck = 4;     // pixels; smaller pieces are noise
constexpr std::array<std::pair<int, int>, 4> kNeighbours{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// Deviation along the ray of structured light (Nguyen, Izadi, Lovell 2012), facing surfaces.
float depth_noise_m(float z_m) { return 0.0012F + 0.0019F * (z_m - 0.4F) * (z_m - 0.4F); }

/// Normal from the smoothed points left, right, above and below, towards the camera; zero at edges.
Eigen::Vector3f normal_at(const Window& w, int x, int y, float reach_m) {
  const auto slope = [&](int dx, int dy) -> Eigen::Vector3f {
    const int x0 = x - dx, y0 = y - dy, x1 = x + dx, y1 = y + dy;
    if (x0 < 0 || y0 < 0 || x1 >= w.width || y1 >= w.height) return Eigen::Vector3f::Zero();
    const std::size_t a = w.index(x0, y0), b = w.index(x1, y1);
    if (w.where[a] == Where::kNothing || w.where[b] == Where::kNothing) return Eigen::Vector3f::Zero();
    const Eigen::Vector3f d = w.smooth[b] - w.smooth[a];
    return d.squaredNorm() > reach_m * reach_m ? Eigen::Vector3f(Eigen::Vector3f::Zero()) : d;
  };
  const Eigen::Vector3f n = slope(kNormalReach, 0).cross(slope(0, kNormalReach));
  const float length = n.norm();
  if (!(length > 0.0F)) return Eigen::Vector3f::Zero();
  return n.dot(w.camera_map - w.smooth[w.index(x, y)]) < 0.0F ? Eigen::Vector3f(-n / length)
                                                              : Eigen::Vector3f(n / length);
}

float colour_distance(const Rgb& a, const Rgb& b) {
  const auto square = [](int d) { return static_cast<float>(d * d); };
  return std::sqrt(square(a.r - b.r) + square(a.g - b.g) + square(a.b - b.b));
}

struct Growth {
  const Window& window;
  const Relief& relief;
  float neighbour_m, normal_dot, colour;

  /// Proximity, smoothness, colour.
  [[nodiscard]] bool connects(std::size_t a, std::size_t b) const {
    if ((window.smooth[a] - window.smooth[b]).squaredNorm() > neighbour_m * neighbour_m) return false;
    const Eigen::Vector3f &na = relief.normals[a], &nb = relief.normals[b];
    const bool have_normals = na.squaredNorm() > 0.0F && nb.squaredNorm() > 0.0F;
    if (have_normals && na.dot(nb) < normal_dot) return false;
    return colour_distance(window.colours[a], window.colours[b]) <= colour;
  }
};

/// Grows one piece from a seed; labels its pixels.
Piece grown(const Growth& growth, std::size_t seed, std::vector<bool>& taken) {
  const Window& w = growth.window;
  Piece piece;
  std::vector<std::size_t> open{seed};
  taken[seed] = true;
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    piece.members.push_back(static_cast<std::uint32_t>(i));
    piece.at_image_border = piece.at_image_border || w.at_image_border(i);
    const int x = static_cast<int>(i) % w.width, y = static_cast<int>(i) / w.width;
    for (const auto& [dx, dy] : kNeighbours) {
      if (x + dx < 0 || y + dy < 0 || x + dx >= w.width || y + dy >= w.height) continue;
      const std::size_t j = w.index(x + dx, y + dy);
      const float step_m = (w.smooth[i] - w.smooth[j]).norm();
      const bool continues = w.where[j] == Where::kOutside && step_m < growth.neighbour_m;
      if (continues) piece.contact_m += static_cast<double>(w.range_m[i]) / 540.0;
      if (!growth.relief.standing[j] || taken[j] || !growth.connects(i, j)) continue;
      taken[j] = true;
      open.push_back(j);
    }
  }
  std::sort(piece.members.begin(), piece.members.end());
  return piece;
}

std::size_t root_of(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

std::int64_t square_key(std::int64_t x, std::int64_t y) { return (x << 32) ^ (y & 0xFFFFFFFF); }

}  // namespace

Relief relief_of(const Window& window, const Plane& ground, const Params& params) {
  const std::size_t n = window.where.size();
  Relief relief{std::vector<float>(n, 0.0F), std::vector<Eigen::Vector3f>(n, Eigen::Vector3f::Zero()),
                std::vector<bool>(n, false)};
  const Eigen::Vector3f up = ground.normal_map.cast<float>();
  for (std::size_t i = 0; i < n; ++i) {
    if (window.where[i] != Where::kInside) continue;
    relief.height_m[i] = height_above(ground, window.smooth[i]);
    const Eigen::Vector3f ray = window.smooth[i] - window.camera_map;
    const float noise_m = kNoiseFactor * depth_noise_m(window.range_m[i]) * std::abs(up.dot(ray)) / ray.norm();
    relief.standing[i] = relief.height_m[i] > std::max(static_cast<float>(params.plane_distance_m), noise_m);
    if (!relief.standing[i]) continue;
    const float reach_m = 2.0F * static_cast<float>(params.neighbour_distance_m);
    relief.normals[i] =
        normal_at(window, static_cast<int>(i) % window.width, static_cast<int>(i) / window.width, reach_m);
  }
  return relief;
}

std::vector<Piece> pieces_of(const Window& window, const Relief& relief, const Params& params) {
  const Growth growth{window, relief, static_cast<float>(params.neighbour_distance_m),
                      static_cast<float>(params.min_normal_dot), static_cast<float>(params.max_colour_distance)};
  std::vector<bool> taken(window.where.size(), false);
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < window.where.size(); ++i) {
    if (!relief.standing[i] || taken[i]) continue;
    Piece piece = grown(growth, i, taken);
    if (piece.members.size() >= kSpeck) pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::vector<Piece> joined(const std::vector<Piece>& pieces, const Window& window, const Params& params) {
  std::vector<std::size_t> parent(pieces.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  // Squares of half the gap; a footprint reaches the squares within one and a half gaps, as a gap is not a contact.
  const double edge_m = std::max(0.002, params.gap_m / 2.0);
  std::unordered_map<std::int64_t, std::size_t> owner;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    for (const std::uint32_t i : pieces[k].members) {
      const std::int64_t x = std::llround(std::floor(static_cast<double>(window.smooth[i].x()) / edge_m));
      const std::int64_t y = std::llround(std::floor(static_cast<double>(window.smooth[i].y()) / edge_m));
      const auto [own, fresh] = owner.try_emplace(square_key(x, y), k);
      if (!fresh) {
        parent[root_of(parent, k)] = root_of(parent, own->second);
        continue;
      }
      for (std::int64_t d = 0; d < 25; ++d) {
        const auto near = owner.find(square_key(x + d % 5 - 2, y + d / 5 - 2));
        if (near != owner.end()) parent[root_of(parent, k)] = root_of(parent, near->second);
      }
    }
  }
  std::unordered_map<std::size_t, std::size_t> place;
  std::vector<Piece> clusters;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto [at, fresh] = place.try_emplace(root_of(parent, k), clusters.size());
    if (fresh) clusters.emplace_back();
    Piece& cluster = clusters[at->second];
    cluster.members.insert(cluster.members.end(), pieces[k].members.begin(), pieces[k].members.end());
    cluster.contact_m += pieces[k].contact_m;
    cluster.at_image_border = cluster.at_image_border || pieces[k].at_image_border;
  }
  for (Piece& cluster : clusters) std::sort(cluster.members.begin(), cluster.members.end());
  return clusters;
}

}  // namespace amiss::segment::internal
