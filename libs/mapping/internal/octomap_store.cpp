// The oracle: liboctomap's OcTree keeps the log-odds.
#include <octomap/octomap.h>

#include <algorithm>
#include <cmath>

#include "mapping/internal/store.hpp"

namespace amiss::mapping {
namespace {

octomap::OcTreeKey key_of(Voxel v) {
  const auto key = [](int i) { return static_cast<octomap::key_type>(i + kVoxelLimit); };
  return {key(v.x), key(v.y), key(v.z)};
}
Voxel voxel_of(const octomap::OcTreeKey& key) {
  return {int{key[0]} - kVoxelLimit, int{key[1]} - kVoxelLimit, int{key[2]} - kVoxelLimit};
}
float odds(std::int16_t steps) { return static_cast<float>(steps / kStepsPerUnit); }
double probability(std::int16_t steps) { return 1.0 / (1.0 + std::exp(-steps / kStepsPerUnit)); }

class OctomapStore : public VoxelMap::Store {
 public:
  OctomapStore(const LogOddsSteps& steps, double resolution_m) : steps_(steps), tree_(resolution_m) {
    tree_.setProbHit(probability(steps.hit));
    tree_.setProbMiss(probability(steps.miss));
    tree_.setClampingThresMin(probability(steps.low));
    tree_.setClampingThresMax(probability(steps.high));
  }
  OctomapStore(const OctomapStore& other) = default;
  OctomapStore& operator=(const OctomapStore&) = delete;

  [[nodiscard]] std::unique_ptr<VoxelMap::Store> clone() const override {
    return std::make_unique<OctomapStore>(*this);
  }

  bool apply(std::uint32_t, const BlockEvidence& evidence, ValueBlock& block) override {
    bool changed = false;
    for_each_bit(evidence.key, evidence.hit, [&](Voxel v) { changed |= add(v, steps_.hit, block); });
    for_each_bit(evidence.key, evidence.miss, [&](Voxel v) { changed |= add(v, steps_.miss, block); });
    return changed;
  }

  void set(std::uint32_t, Voxel v, std::optional<std::int16_t> steps) override {
    // A voxel that became unknown keeps a node: OcTree::deleteNode asserts when it takes a parent's last child away.
    tree_.setNodeValue(key_of(v), odds(std::clamp(steps.value_or(std::int16_t{0}), steps_.low, steps_.high)));
  }

  [[nodiscard]] std::int16_t steps(std::uint32_t, Voxel v) const override {
    const octomap::OcTreeNode* node = tree_.search(key_of(v));
    return node == nullptr ? std::int16_t{0} : log_odds_steps(double{node->getLogOdds()});
  }

  std::optional<std::vector<Changed>> insert_rays(const Cloud<Map>& points, const Point<Map>& origin) override {
    octomap::Pointcloud cloud;
    cloud.reserve(points.points.size());
    for (const Eigen::Vector3f& p : points.points) cloud.push_back(p.x(), p.y(), p.z());
    tree_.resetChangeDetection();
    tree_.enableChangeDetection(true);
    tree_.insertPointCloud(cloud, octomap::point3d(static_cast<float>(origin.p.x()), static_cast<float>(origin.p.y()),
                                                   static_cast<float>(origin.p.z())));
    std::vector<Changed> changed;
    for (auto it = tree_.changedKeysBegin(); it != tree_.changedKeysEnd(); ++it) {
      changed.push_back({voxel_of(it->first), tree_.isNodeOccupied(tree_.search(it->first))});
    }
    tree_.enableChangeDetection(false);
    tree_.resetChangeDetection();
    std::sort(changed.begin(), changed.end(), [](const Changed& a, const Changed& b) { return a.voxel < b.voxel; });
    return changed;
  }

 private:
  bool add(Voxel v, std::int16_t update, ValueBlock& block) {
    const auto layer = static_cast<std::size_t>(v.z & 7);
    const std::uint64_t bit = std::uint64_t{1} << bit_in_layer(v);
    const bool known = (block.known[layer] & bit) != 0;
    const int before = known ? steps(0, v) : 0;
    const int after = std::clamp<int>(before + update, steps_.low, steps_.high);
    if (known && after == before) return false;
    tree_.setNodeValue(key_of(v), odds(static_cast<std::int16_t>(after)));
    const std::uint64_t occupied = after >= 0 ? block.occupied[layer] | bit : block.occupied[layer] & ~bit;
    const bool changed = !known || occupied != block.occupied[layer];
    block.known[layer] |= bit;
    block.occupied[layer] = occupied;
    return changed;
  }

  LogOddsSteps steps_;
  octomap::OcTree tree_;
};

}  // namespace

std::unique_ptr<VoxelMap::Store> make_octomap_store(const LogOddsSteps& steps, double resolution_m) {
  return std::make_unique<OctomapStore>(steps, resolution_m);
}

}  // namespace amiss::mapping
