// Where a VoxelMap keeps its log-odds. Values travel as whole steps of 1/1024, so that all stores add up the same.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "mapping/internal/evidence.hpp"
#include "mapping/voxel_map.hpp"

namespace amiss::mapping {

/// Log-odds in steps of 1/1024.
struct LogOddsSteps {
  std::int16_t hit = 0, miss = 0, low = 0, high = 0;
};
inline constexpr double kStepsPerUnit = 1024.0;
[[nodiscard]] std::int16_t log_odds_steps(double log_odds);

class VoxelMap::Store {
 public:
  virtual ~Store() = default;
  [[nodiscard]] virtual std::unique_ptr<Store> clone() const = 0;

  /// Add the evidence to the log-odds of `block`, which lies in `slot`, and bring its planes up to date.
  /// Returns whether a value changed.
  virtual bool apply(std::uint32_t slot, const BlockEvidence& evidence, ValueBlock& block) = 0;
  /// One voxel; nothing = unknown. The planes are the caller's.
  virtual void set(std::uint32_t slot, Voxel v, std::optional<std::int16_t> steps) = 0;
  [[nodiscard]] virtual std::int16_t steps(std::uint32_t slot, Voxel v) const = 0;

  /// The store's own way to insert rays: voxels that may have changed and whether they are occupied now; nothing where
  /// it has none.
  struct Changed {
    Voxel voxel;
    bool occupied = false;
  };
  virtual std::optional<std::vector<Changed>> insert_rays(const Cloud<Map>& points, const Point<Map>& origin);

  HitCounts hits;
};

[[nodiscard]] std::unique_ptr<VoxelMap::Store> make_block_store(const LogOddsSteps& steps);
[[nodiscard]] std::unique_ptr<VoxelMap::Store> make_octomap_store(const LogOddsSteps& steps, double resolution_m);

}  // namespace amiss::mapping
