#include "change/region.hpp"

#include <algorithm>
#include <optional>

namespace amiss::change {

using mapping::BlockBits;
using mapping::Voxel;
using mapping::VoxelBlocks;
using mapping::VoxelMap;

namespace {

/// Every voxel at most sqrt(2) voxels away, and itself.
template <class Visit>
void for_each_near(Voxel v, Visit visit) {
  for (int dz = -1; dz <= 1; ++dz) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (dx * dx + dy * dy + dz * dz <= 2) visit(Voxel{v.x + dx, v.y + dy, v.z + dz});
      }
    }
  }
}

/// Takes the voxel out of the set of those that are left; false where it was not in it.
bool take(VoxelBlocks& left, Voxel v) {
  if (left.at(v) != Occupancy::kOccupied) return false;
  const std::uint32_t slot = left.find(mapping::block_of(v));
  left.at_slot(slot).occupied[static_cast<std::size_t>(v.z & 7)] &= ~(std::uint64_t{1} << mapping::bit_in_layer(v));
  return true;
}

Region region_of(std::vector<Voxel> voxels, const VoxelMap& map, int min_hit_frames) {
  Region region;
  const Voxel& first = voxels.front();
  Voxel low = first, high = first;
  for (const Voxel& v : voxels) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    region.voxel_centres_m.push_back(map.centre_of(v).cast<float>());
    const int frames = map.hit_frames(v);
    region.hit_frames = std::max(region.hit_frames, frames);
    if (frames >= min_hit_frames) ++region.evident_voxels;
  }
  const double res = map.resolution_m();
  region.centre_m = {0.5 * res * (low.x + high.x + 1), 0.5 * res * (low.y + high.y + 1)};
  region.z_low_m = res * low.z;
  region.z_high_m = res * (high.z + 1);
  for (const Voxel& v : voxels) {
    const Eigen::Vector2d off = (map.centre_of(v).head<2>() - region.centre_m).cwiseAbs();
    region.radius_m = std::max(region.radius_m, (off + Eigen::Vector2d::Constant(0.5 * res)).norm());
  }
  region.voxels = std::move(voxels);
  return region;
}

bool is_of_interest(const Region& region, double resolution_m, const RegionParams& p) {
  const auto size = static_cast<int>(region.voxels.size());
  const bool evident = region.evident_voxels >= p.min_voxels;
  const bool lone = p.min_hit_frames > 0 && region.hit_frames >= p.lone_hit_frames;
  if (!(evident || lone) || size > p.max_voxels) return false;
  constexpr double kSpareM = 1e-6;
  if (region.z_high_m - region.z_low_m > p.max_height_m + kSpareM) return false;
  if (region.z_low_m > p.max_floor_gap_m + kSpareM) return false;
  const auto [low, high] = std::minmax_element(region.voxels.begin(), region.voxels.end(),
                                               [](const Voxel& a, const Voxel& b) { return a.y < b.y; });
  const int across = std::max(region.voxels.back().x - region.voxels.front().x, high->y - low->y) + 1;
  return across * resolution_m <= p.max_across_m + kSpareM;
}

}  // namespace

void describe(ParamTable& table, RegionParams& p) {
  table.integer("change.min_voxels", p.min_voxels, 1, 1000, "fewest voxels of a region, each of them evident (c_min)");
  table.integer("change.max_voxels", p.max_voxels, 1, 1000000, "most voxels of a region (c_max)");
  table.number("change.max_height", p.max_height_m, "m", 0.05, 3, "greatest height of a region (c_height)");
  table.number("change.max_across", p.max_across_m, "m", 0.05, 5, "greatest extent of a region in x and y");
  table.number("change.max_floor_gap", p.max_floor_gap_m, "m", 0, 3, "how far above the floor a region may begin");
  table.integer("change.min_hit_frames", p.min_hit_frames, 0, 255, "frames that must have hit a voxel to believe it");
  table.integer("change.lone_hit_frames", p.lone_hit_frames, 1, 255,
                "frames that must have hit a voxel to believe it where there are fewer than c_min");
}

std::vector<std::vector<Voxel>> clusters(const std::vector<Voxel>& voxels) {
  VoxelBlocks left;
  for (const Voxel& v : voxels) {
    mapping::ValueBlock& block = left.at_slot(left.find_or_add(mapping::block_of(v)));
    const std::uint64_t bit = std::uint64_t{1} << mapping::bit_in_layer(v);
    block.known[static_cast<std::size_t>(v.z & 7)] |= bit;
    block.occupied[static_cast<std::size_t>(v.z & 7)] |= bit;
  }
  std::vector<std::vector<Voxel>> groups;
  for (const Voxel& seed : voxels) {
    if (!take(left, seed)) continue;
    std::vector<Voxel> group{seed};
    for (std::size_t next = 0; next < group.size(); ++next) {
      for_each_near(group[next], [&](Voxel v) {
        if (take(left, v)) group.push_back(v);
      });
    }
    std::sort(group.begin(), group.end());
    groups.push_back(std::move(group));
  }
  std::sort(groups.begin(), groups.end());
  return groups;
}

std::vector<Region> regions(const std::vector<Voxel>& appeared, const VoxelMap& current, const RegionParams& params) {
  std::vector<Region> found;
  for (std::vector<Voxel>& group : clusters(appeared)) {
    Region region = region_of(std::move(group), current, params.min_hit_frames);
    if (is_of_interest(region, current.resolution_m(), params)) found.push_back(std::move(region));
  }
  return found;
}

}  // namespace amiss::change
