#include "mapping/internal/surface_kernel.hpp"

#include <algorithm>
#include <cmath>

#include "mapping/internal/block_projection.hpp"
#include "mapping/internal/wide.hpp"

namespace amiss::mapping {
namespace {

constexpr float kNearM = kNearPlaneM;

AMISS_WIDE void blend_distances(const float* seen, const float* weight, float max_weight, float* distance,
                                float* total) {
  for (int i = 0; i < kBlockVoxels; ++i) {
    const float sum = total[i] + weight[i];
    const float mean = (distance[i] * total[i] + seen[i] * weight[i]) / std::max(sum, 1e-20f);
    distance[i] = weight[i] > 0.0f ? mean : distance[i];
    total[i] = std::min(sum, max_weight);
  }
}

/// Voxel centres in the camera frame [m]. All loops run over the whole block, so that eight voxels are done at once.
struct Places {
  float x[kBlockVoxels], y[kBlockVoxels], z[kBlockVoxels];
};
struct Sights {
  float stretch[kBlockVoxels];  // length of the ray for a z of 1
  std::int32_t inside[kBlockVoxels], coarse[kBlockVoxels];
  float code[kBlockVoxels];
};

AMISS_WIDE void place_voxels(const VoxelLattice& l, Places* places) {
  for (int row = 0; row < kBlockEdge * kBlockEdge; ++row) {
    const auto fy = static_cast<float>(row & 7), fz = static_cast<float>(row >> 3);
    const float px = l.first[0] + fy * l.b[0] + fz * l.c[0];
    const float py = l.first[1] + fy * l.b[1] + fz * l.c[1];
    const float pz = l.first[2] + fy * l.b[2] + fz * l.c[2];
    for (int x = 0; x < kBlockEdge; ++x) {
      const auto f = static_cast<float>(x);
      places->x[kBlockEdge * row + x] = px + f * l.a[0];
      places->y[kBlockEdge * row + x] = py + f * l.a[1];
      places->z[kBlockEdge * row + x] = pz + f * l.a[2];
    }
  }
}

AMISS_WIDE void project(SurfaceView view, const Places& places, Sights* sights, std::int32_t* pixel) {
  const float right = static_cast<float>(view.width) - 1.0f, bottom = static_cast<float>(view.height) - 1.0f;
  for (int i = 0; i < kBlockVoxels; ++i) {
    const float x = places.x[i], y = places.y[i], z = places.z[i];
    const float inverse = 1.0f / (z < kNearM ? kNearM : z);
    const float u = x * inverse * view.fx + (view.cx + 0.5f), v = y * inverse * view.fy + (view.cy + 0.5f);
    const float u_right = u < right ? u : right, v_bottom = v < bottom ? v : bottom;
    const auto column = static_cast<std::int32_t>(u_right > 0.0f ? u_right : 0.0f);
    const auto line = static_cast<std::int32_t>(v_bottom > 0.0f ? v_bottom : 0.0f);
    const auto yes = [](bool b) { return static_cast<std::int32_t>(b); };
    sights->inside[i] =
        yes(z >= kNearM) & yes(u >= 0.0f) & yes(v >= 0.0f) & yes(u < right + 1.0f) & yes(v < bottom + 1.0f);
    sights->stretch[i] = std::sqrt(x * x + y * y + z * z) * inverse;
    sights->coarse[i] = (line >> view.shift) * view.coarse_width + (column >> view.shift);
    pixel[i] = line * view.width + column;
  }
}

AMISS_WIDE void read_codes(SurfaceView view, const std::int32_t* pixel, Sights* sights) {
  for (int i = 0; i < kBlockVoxels; ++i) {
    const float fine = view.fine[pixel[i]], mean = view.coarse[sights->coarse[i]];
    sights->code[i] = mean > 0.0f ? mean : fine;
  }
}

AMISS_WIDE void judge(SurfaceView view, const Places& places, const Sights& sights, BlockLook* look) {
  const float slope = 1.0f / (view.truncation - view.voxel), truncation = view.truncation;
  for (int i = 0; i < kBlockVoxels; ++i) {
    const float code = sights.code[i], z = places.z[i];
    const float along = (code - z) * sights.stretch[i];  // projective distance along the ray
    const float size = code < 0.0f ? -code : code;
    const float ends = (z < kNearM ? kNearM : z) * (size < kNearM ? kNearM : size);
    const float full = view.rays / (ends * ends);
    const float drop = (truncation + along) * slope;
    const float part = drop < 1.0f ? (drop > 0.0f ? drop : 0.0f) : 1.0f;
    const float clears = -code > z ? full : 0.0f;
    const float cut = along < truncation ? along : truncation;
    const float weight = code > 0.0f ? full * part : clears;
    look->distance_m[i] = code > 0.0f ? cut : truncation;
    look->weight[i] = sights.inside[i] != 0 ? weight : 0.0f;
  }
}

std::uint8_t mixed(std::uint8_t old, std::uint8_t seen, float part) {
  const float o = old;
  return static_cast<std::uint8_t>(o + (static_cast<float>(seen) - o) * part + 0.5f);
}

}  // namespace

void look_at_voxels(SurfaceView view, const VoxelLattice& lattice, BlockLook* look) {
  Places places;
  place_voxels(lattice, &places);
  Sights sights;
  project(view, places, &sights, look->pixel);
  read_codes(view, look->pixel, &sights);
  judge(view, places, sights, look);
}

AMISS_WIDE bool near_surface(const BlockLook& look, float truncation) {
  std::int32_t any = 0;
  for (int i = 0; i < kBlockVoxels; ++i) {
    any |=
        static_cast<std::int32_t>(look.weight[i] > 0.0f) & static_cast<std::int32_t>(look.distance_m[i] < truncation);
  }
  return any != 0;
}

void blend(const BlockLook& look, const Rgb* image, float truncation, float max_weight, SurfaceVoxels& voxels) {
  for (std::size_t i = 0; i < kBlockVoxels; ++i) {
    const float weight = look.weight[i];
    if (weight <= 0.0f || std::abs(look.distance_m[i]) >= truncation) continue;
    const float part = weight / (weight + voxels.weight[i]);
    const Rgb seen = image[look.pixel[i]];
    Rgb& colour = voxels.colour[i];
    colour = {mixed(colour.r, seen.r, part), mixed(colour.g, seen.g, part), mixed(colour.b, seen.b, part)};
  }
  blend_distances(look.distance_m, look.weight, max_weight, voxels.distance_m.data(), voxels.weight.data());
}

}  // namespace amiss::mapping
