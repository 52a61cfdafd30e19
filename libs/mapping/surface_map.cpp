#include "mapping/surface_map.hpp"

#include <algorithm>
#include <cmath>

#include "core/result.hpp"
#include "mapping/internal/block_projection.hpp"
#include "mapping/internal/frame_check.hpp"
#include "mapping/internal/surface_image.hpp"
#include "mapping/internal/surface_kernel.hpp"

namespace amiss::mapping {
namespace {

constexpr int kLargestCube = 8;            // blocks; what one look at the pyramid can decide
constexpr double kMeanCrossSection = 1.5;  // of a cube of edge 1, over all directions (Cauchy: a quarter of its face)
constexpr double kPixelsOfMean = 2.0;      // a voxel looks at means of pixels half its size
constexpr float kSpareM = 1e-4f;

void check(const SurfaceParams& p) {
  const auto require = [](bool good, const char* sentence) {
    if (!good) throw ArgumentError(sentence);
  };
  require(p.voxel_m >= 0.001 && p.voxel_m <= 0.5, "surface.voxel: allowed are 0.001 to 0.5 m");
  require(p.truncation_voxels >= 2.0 && p.truncation_voxels <= 32.0, "surface.truncation: allowed are 2 to 32 voxels");
  require(p.min_range_m > 0.0 && p.max_range_m > p.min_range_m,
          "surface.min_range must be positive and less than surface.max_range");
  require(p.max_range_m / p.voxel_m <= 2000.0, "surface.max_range: allowed are 2000 voxels at most");
  require(p.max_weight > 0.0, "surface.max_weight must be positive");
}

VoxelMapParams limits_of(const SurfaceParams& p) {
  VoxelMapParams limits;
  limits.resolution_m = p.voxel_m;
  limits.max_range_m = limits.max_hit_range_m = p.max_range_m + p.truncation_m();
  limits.pixel_step = 1;
  return limits;
}

}  // namespace

class SurfaceMap::Scratch {
 public:
  SurfaceImage image;
  BlockLook look;
};

/// One frame, as its blocks see it.
struct SurfaceMap::Sight {
  const RgbdFrame& frame;
  Frustum frustum;
  float truncation, voxel, rays;

  [[nodiscard]] Eigen::Vector3f corner_local(BlockKey key) const {
    return Eigen::Vector3f(static_cast<float>(key.x - frustum.low.x), static_cast<float>(key.y - frustum.low.y),
                           static_cast<float>(key.z - frustum.low.z)) *
           static_cast<float>(kBlockEdge);
  }
  [[nodiscard]] Eigen::Vector3f centre_camera(BlockKey key) const {
    return frustum.R_camera_local * (corner_local(key) + Eigen::Vector3f::Constant(0.5f * kBlockEdge)) +
           frustum.t_camera_local;
  }
};

void describe(ParamTable& table, SurfaceParams& p) {
  table.number("surface.voxel", p.voxel_m, "m", 0.001, 0.5, "edge of a voxel (Table 5.1: TSDF voxel size)");
  table.number("surface.truncation", p.truncation_voxels, "voxels", 2, 32, "where distances are cut");
  table.number("surface.min_range", p.min_range_m, "m", 0.01, 2, "depth under which pixels are not believed");
  table.number("surface.max_range", p.max_range_m, "m", 0.2, 10, "longest ray (Table 5.1: max. ray length)");
  table.number("surface.max_weight", p.max_weight, "", 1, 1e6, "where the weight of a voxel stops to grow");
}

SurfaceMap::SurfaceMap(const SurfaceParams& params) : params_(params), scratch_(std::make_unique<Scratch>()) {
  check(params);
}
SurfaceMap::SurfaceMap(SurfaceMap&&) noexcept = default;
SurfaceMap& SurfaceMap::operator=(SurfaceMap&&) noexcept = default;
SurfaceMap::~SurfaceMap() = default;
SurfaceMap::SurfaceMap(const SurfaceMap& other)
    : params_(other.params_),
      values_(other.values_),
      free_weights_(other.free_weights_),
      scratch_(std::make_unique<Scratch>()) {
  for (const auto& surface : other.surfaces_) {
    surfaces_.push_back(surface ? std::make_unique<SurfaceVoxels>(*surface) : nullptr);
  }
}
SurfaceMap& SurfaceMap::operator=(const SurfaceMap& other) {
  if (this != &other) *this = SurfaceMap(other);
  return *this;
}

std::uint32_t SurfaceMap::slot_of(BlockKey key) {
  const std::uint32_t slot = values_.find_or_add(key);
  if (slot == surfaces_.size()) {
    surfaces_.emplace_back();
    free_weights_.push_back(0.0f);
  }
  return slot;
}

SurfaceVoxels& SurfaceMap::surface_of(std::uint32_t slot) {
  if (surfaces_[slot]) return *surfaces_[slot];
  surfaces_[slot] = std::make_unique<SurfaceVoxels>();
  SurfaceVoxels& voxels = *surfaces_[slot];
  const auto truncation = static_cast<float>(params_.truncation_m());
  const ValueBlock& block = values_.at_slot(slot);
  for_each_bit(block.key, block.known, [&](Voxel v) {
    voxels.distance_m[index_in_block(v)] = truncation;
    voxels.weight[index_in_block(v)] = free_weights_[slot];
  });
  free_weights_[slot] = 0.0f;
  return voxels;
}

void SurfaceMap::update_values(std::uint32_t slot) {
  const SurfaceVoxels& voxels = *surfaces_[slot];
  ValueBlock& block = values_.at_slot(slot);
  const auto voxel = static_cast<float>(params_.voxel_m);
  for (std::size_t layer = 0; layer < kBlockEdge; ++layer) {
    std::uint64_t known = 0, occupied = 0;
    for (std::size_t bit = 0; bit < 64; ++bit) {
      const std::size_t i = 64 * layer + bit;
      const bool seen = voxels.weight[i] > 0.0f && voxels.distance_m[i] >= -voxel;
      const bool surface = seen && voxels.distance_m[i] <= voxel;
      known |= std::uint64_t{seen} << bit;
      occupied |= std::uint64_t{surface} << bit;
    }
    block.known[layer] = known;
    block.occupied[layer] = occupied;
  }
}

void SurfaceMap::free_block(const Sight& sight, BlockKey key) {
  const std::uint32_t slot = slot_of(key);
  if (surfaces_[slot]) {
    look_at_block(sight, key);
    return;
  }
  values_.at_slot(slot).known.fill(~std::uint64_t{0});
  const float z = std::max(sight.centre_camera(key).z(), kNearPlaneM);
  const auto end = static_cast<float>(params_.max_range_m);  // of the ray: the weight counts where a surface appears
  free_weights_[slot] =
      std::min(free_weights_[slot] + sight.rays / (z * z * end * end), static_cast<float>(params_.max_weight));
}

void SurfaceMap::look_at_block(const Sight& sight, BlockKey key) {
  const SurfaceImage& image = scratch_->image;
  const Eigen::Matrix3f& R = sight.frustum.R_camera_local;
  const Eigen::Vector3f first =
      R * (sight.corner_local(key) + Eigen::Vector3f::Constant(0.5f)) + sight.frustum.t_camera_local;
  VoxelLattice lattice{};
  for (int k = 0; k < 3; ++k) {
    lattice.first[k] = first[k];
    lattice.a[k] = R(k, 0);
    lattice.b[k] = R(k, 1);
    lattice.c[k] = R(k, 2);
  }
  const float pixels = sight.frustum.fx * sight.voxel / std::max(sight.centre_camera(key).z(), kNearPlaneM);
  const int level = std::clamp(static_cast<int>(std::floor(std::log2(pixels / static_cast<float>(kPixelsOfMean)))), 0,
                               SurfaceImage::kLevels - 1);
  const SurfaceView view{
      image.codes(0),   image.codes(level), image.width(0),   image.height(0),  image.width(level), level,
      sight.frustum.fx, sight.frustum.fy,   sight.frustum.cx, sight.frustum.cy, sight.truncation,   sight.voxel,
      sight.rays};
  BlockLook& look = scratch_->look;
  look_at_voxels(view, lattice, &look);
  const bool near = near_surface(look, sight.truncation);
  const std::uint32_t known_slot = values_.find(key);
  const auto max_weight = static_cast<float>(params_.max_weight);
  if (near || (known_slot != VoxelBlocks::kNone && surfaces_[known_slot])) {
    const std::uint32_t slot = slot_of(key);
    blend(look, sight.frame.colour.data(), sight.truncation, max_weight, surface_of(slot));
    update_values(slot);
    return;
  }
  BlockBits seen{};
  float sum = 0.0f;
  for (std::size_t i = 0; i < kBlockVoxels; ++i) {
    seen[i / 64] |= std::uint64_t{look.weight[i] > 0.0f} << (i % 64);
    sum += look.weight[i];
  }
  if (sum <= 0.0f) return;
  const std::uint32_t slot = slot_of(key);
  for (std::size_t layer = 0; layer < kBlockEdge; ++layer) values_.at_slot(slot).known[layer] |= seen[layer];
  free_weights_[slot] = std::min(free_weights_[slot] + sum / static_cast<float>(kBlockVoxels), max_weight);
}

void SurfaceMap::look_at_cube(const Sight& sight, BlockKey low, int edge_blocks) {
  const DepthPyramid& reach = scratch_->image.reach();
  const CubeProjection cube =
      project_cube(sight.frustum, sight.corner_local(low), edge_blocks * kBlockEdge, reach.width(), reach.height());
  if (cube.place == CubeProjection::Place::kNowhere) return;
  bool all_free = false;
  if (cube.place == CubeProjection::Place::kSeen) {
    const DepthPyramid::Range range = reach.range(cube.rect);
    if (range.high <= 0.0f || range.high + 2.0f * sight.truncation <= cube.z_low - kSpareM) return;
    all_free = cube.inside && range.low > cube.z_high + kSpareM;
  }
  if (edge_blocks == 1) {
    if (all_free) {
      free_block(sight, low);
    } else {
      look_at_block(sight, low);
    }
    return;
  }
  const int step = all_free ? 1 : edge_blocks / 2;
  for (int z = 0; z < edge_blocks; z += step) {
    for (int y = 0; y < edge_blocks; y += step) {
      for (int x = 0; x < edge_blocks; x += step) {
        const BlockKey part{low.x + x, low.y + y, low.z + z};
        if (all_free) {
          free_block(sight, part);
        } else {
          look_at_cube(sight, part, step);
        }
      }
    }
  }
}

void SurfaceMap::insert(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera) {
  check_frame(frame, T_map_camera, params_.voxel_m);
  if (frame.colour.size() != frame.depth_m.size()) {
    throw InputError("frame: colour and depth must have equally many pixels");
  }
  scratch_->image.prepare(frame, params_);
  const CameraIntrinsics& k = frame.intrinsics;
  const double rays = kMeanCrossSection * k.fx * k.fy * params_.voxel_m * params_.voxel_m;
  const Sight sight{frame, frustum_of(k, T_map_camera, limits_of(params_)), static_cast<float>(params_.truncation_m()),
                    static_cast<float>(params_.voxel_m), static_cast<float>(rays)};
  const Frustum& f = sight.frustum;
  for (int z = 0; z < f.nz; z += kLargestCube) {
    for (int y = 0; y < f.ny; y += kLargestCube) {
      for (int x = 0; x < f.nx; x += kLargestCube) {
        look_at_cube(sight, {f.low.x + x, f.low.y + y, f.low.z + z}, kLargestCube);
      }
    }
  }
}

}  // namespace amiss::mapping
