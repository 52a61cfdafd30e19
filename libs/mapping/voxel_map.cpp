#include "mapping/voxel_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/result.hpp"
#include "mapping/internal/depth_evidence.hpp"
#include "mapping/internal/frame_check.hpp"
#include "mapping/internal/ray_evidence.hpp"
#include "mapping/internal/store.hpp"

namespace amiss::mapping {
namespace {

void check(const VoxelMapParams& p) {
  const auto require = [](bool good, const char* sentence) {
    if (!good) throw ArgumentError(sentence);
  };
  require(p.store == "blocks" || p.store == "octomap", "mapping.store: allowed are blocks and octomap");
  require(p.resolution_m >= 0.001 && p.resolution_m <= 10.0, "mapping.resolution: allowed are 0.001 to 10 m");
  require(p.min_range_m > 0.0 && p.max_range_m > p.min_range_m && p.max_hit_range_m > p.min_range_m,
          "mapping.min_range must be positive and less than mapping.max_range and mapping.max_hit_range");
  require(std::max(p.max_range_m, p.max_hit_range_m) / p.resolution_m <= 2000.0,
          "mapping.max_range and mapping.max_hit_range: allowed are 2000 voxels at most");
  require(p.pixel_step >= 1, "mapping.pixel_step: allowed are 1 and more");
  require(p.hit_log_odds > 0.0 && p.miss_log_odds < 0.0 && p.clamp_low < 0.0 && p.clamp_high > 0.0,
          "mapping.hit and mapping.clamp_high must be positive, mapping.miss and mapping.clamp_low negative");
}

}  // namespace

void describe(ParamTable& table, VoxelMapParams& p) {
  table.choice("mapping.store", p.store, {"blocks", "octomap"}, "what keeps the log-odds");
  table.number("mapping.resolution", p.resolution_m, "m", 0.01, 0.5, "edge of a voxel (res)");
  table.number("mapping.min_range", p.min_range_m, "m", 0.05, 2, "depth under which pixels are not believed");
  table.number("mapping.max_range", p.max_range_m, "m", 0.5, 10, "how far rays free the space");
  table.number("mapping.max_hit_range", p.max_hit_range_m, "m", 0.5, 10, "depth beyond which pixels hit nothing");
  table.integer("mapping.pixel_step", p.pixel_step, 1, 8, "every how many-th row and column of the depth is used");
  table.integer("mapping.min_end_points", p.min_end_points, 1, 100, "end points that make a voxel hit");
  table.number("mapping.min_end_fraction", p.min_end_fraction, "", 0, 1,
               "end points that make a voxel hit, as a share of the pixels its face covers; grows beyond 2 m");
  table.number("mapping.hit", p.hit_log_odds, "", 0.01, 10, "log-odds of a hit");
  table.number("mapping.miss", p.miss_log_odds, "", -10, -0.01, "log-odds of a miss");
  table.number("mapping.clamp_low", p.clamp_low, "", -15, -0.1, "least log-odds");
  table.number("mapping.clamp_high", p.clamp_high, "", 0.1, 15, "greatest log-odds");
}

std::int16_t log_odds_steps(double log_odds) {
  const double limit = 15.0;
  const auto steps = std::lround(std::clamp(log_odds, -limit, limit) * kStepsPerUnit);
  return static_cast<std::int16_t>(steps == 0 && log_odds < 0.0 ? -1 : steps);  // never rounded to occupied
}

std::optional<std::vector<VoxelMap::Store::Changed>> VoxelMap::Store::insert_rays(const Cloud<Map>&,
                                                                                  const Point<Map>&) {
  return std::nullopt;
}

class VoxelMap::Scratch {
 public:
  DepthEvidence depth;
};

VoxelMap::VoxelMap(const VoxelMapParams& params) : params_(params), scratch_(std::make_unique<Scratch>()) {
  check(params);
  const LogOddsSteps steps{log_odds_steps(params.hit_log_odds), log_odds_steps(params.miss_log_odds),
                           log_odds_steps(params.clamp_low), log_odds_steps(params.clamp_high)};
  store_ = params.store == "octomap" ? make_octomap_store(steps, params.resolution_m) : make_block_store(steps);
}

VoxelMap::VoxelMap(const VoxelMap& other)
    : params_(other.params_),
      values_(other.values_),
      revision_(other.revision_),
      store_(other.store_->clone()),
      scratch_(std::make_unique<Scratch>()) {}

VoxelMap& VoxelMap::operator=(const VoxelMap& other) {
  if (this != &other) *this = VoxelMap(other);
  return *this;
}

VoxelMap::VoxelMap(VoxelMap&&) noexcept = default;
VoxelMap& VoxelMap::operator=(VoxelMap&&) noexcept = default;
VoxelMap::~VoxelMap() = default;

void VoxelMap::insert(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera) {
  check_frame(frame, T_map_camera, params_.resolution_m);
  const std::uint64_t revision = revision_ + 1;
  for (const BlockEvidence& evidence : scratch_->depth.look(frame, T_map_camera, params_)) {
    if (!in_limits(voxel_in(evidence.key, 0, 0))) continue;
    const std::uint32_t slot = values_.find_or_add(evidence.key);
    ValueBlock& block = values_.at_slot(slot);
    if (store_->apply(slot, evidence, block)) block.revision = revision_ = revision;
    store_->hits.note(slot, evidence, block);
  }
}

void VoxelMap::insert(const Cloud<Map>& points, const Point<Map>& origin) {
  if (!reachable(origin.p, params_.resolution_m)) {
    throw InputError("cloud: the origin must be finite and within the map's limits");
  }
  Cloud<Map> usable;
  for (const Eigen::Vector3f& p : points.points) {
    if (reachable(p.cast<double>(), params_.resolution_m)) usable.points.push_back(p);
  }
  const std::uint64_t revision = revision_ + 1;
  const auto changes = store_->insert_rays(usable, origin);
  for (const Store::Changed& change : changes.value_or(std::vector<Store::Changed>{})) {
    const std::uint64_t bit = std::uint64_t{1} << bit_in_layer(change.voxel);
    const auto layer = static_cast<std::size_t>(change.voxel.z & 7);
    ValueBlock& block = values_.at_slot(values_.find_or_add(block_of(change.voxel)));
    block.known[layer] |= bit;
    block.occupied[layer] = change.occupied ? block.occupied[layer] | bit : block.occupied[layer] & ~bit;
    block.revision = revision_ = revision;
  }
  for (const BlockEvidence& evidence : ray_evidence(usable, origin, params_.resolution_m)) {
    const std::uint32_t slot = values_.find_or_add(evidence.key);
    ValueBlock& block = values_.at_slot(slot);
    if (!changes && store_->apply(slot, evidence, block)) block.revision = revision_ = revision;
    store_->hits.note(slot, evidence, block);
  }
}

Occupancy VoxelMap::at(const Eigen::Vector3d& p_map) const {
  return reachable(p_map, params_.resolution_m) ? at(voxel_at(p_map)) : Occupancy::kUnknown;
}

void VoxelMap::set(Voxel v, Occupancy value) {
  if (value == Occupancy::kOccupied) return set_log_odds(v, params_.clamp_high);
  if (value == Occupancy::kFree) return set_log_odds(v, params_.clamp_low);
  const std::uint32_t slot = values_.find(block_of(v));
  if (slot == VoxelBlocks::kNone || values_.at(v) == Occupancy::kUnknown) return;
  store_->set(slot, v, std::nullopt);
  store_->hits.clear(slot, index_in_block(v));
  ValueBlock& block = values_.at_slot(slot);
  const std::uint64_t bit = std::uint64_t{1} << bit_in_layer(v);
  block.known[static_cast<std::size_t>(v.z & 7)] &= ~bit;
  block.occupied[static_cast<std::size_t>(v.z & 7)] &= ~bit;
  block.revision = ++revision_;
}

void VoxelMap::set_log_odds(Voxel v, double log_odds) {
  assert(in_limits(v));
  const Occupancy before = values_.at(v);
  const std::uint32_t slot = values_.find_or_add(block_of(v));
  store_->set(slot, v, log_odds_steps(log_odds));
  const bool occupied = log_odds_steps(log_odds) >= 0;
  if (before == (occupied ? Occupancy::kOccupied : Occupancy::kFree)) return;
  store_->hits.clear(slot, index_in_block(v));
  ValueBlock& block = values_.at_slot(slot);
  const std::uint64_t bit = std::uint64_t{1} << bit_in_layer(v);
  const auto layer = static_cast<std::size_t>(v.z & 7);
  block.known[layer] |= bit;
  block.occupied[layer] = occupied ? block.occupied[layer] | bit : block.occupied[layer] & ~bit;
  block.revision = ++revision_;
}

double VoxelMap::log_odds(Voxel v) const {
  const std::uint32_t slot = values_.find(block_of(v));
  return at(v) == Occupancy::kUnknown ? 0.0 : store_->steps(slot, v) / kStepsPerUnit;
}

int VoxelMap::hit_frames(Voxel v) const {
  const std::uint32_t slot = values_.find(block_of(v));
  return slot == VoxelBlocks::kNone ? 0 : store_->hits.at(slot, index_in_block(v));
}

}  // namespace amiss::mapping
