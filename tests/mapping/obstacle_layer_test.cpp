#include "mapping/obstacle_layer.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "core/result.hpp"

namespace amiss::mapping {
namespace {

const FloorGrid kArea(0.1, {-1.0, -0.5}, 20, 15);

/// What the header says, cell by cell.
void expect_projected(const VoxelMap& map, const ObstacleLayer& layer) {
  std::size_t seen_cells = 0;
  for (int y = 0; y < layer.obstacles().height(); ++y) {
    for (int x = 0; x < layer.obstacles().width(); ++x) {
      const Eigen::Vector2d c = layer.obstacles().centre_of({x, y});
      bool occupied = false, seen = false;
      for (int z = 0; z < 22; ++z)
        occupied |= map.at(Eigen::Vector3d(c.x(), c.y(), 0.05 * z + 0.025)) == Occupancy::kOccupied;
      for (const double z : {-0.025, 0.025}) seen |= map.at(Eigen::Vector3d(c.x(), c.y(), z)) != Occupancy::kUnknown;
      const Occupancy open = seen ? Occupancy::kFree : Occupancy::kUnknown;
      RC_ASSERT(layer.obstacles().at(Cell{x, y}) == (occupied ? Occupancy::kOccupied : open));
      RC_ASSERT(layer.seen_floor().at(Cell{x, y}) == open);
      seen_cells += seen ? 1u : 0u;
    }
  }
  RC_ASSERT(layer.seen_cells() == seen_cells);
}

RC_GTEST_PROP(ObstacleLayer, FollowsTheMap, ()) {
  RandomStream random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1000)), "obstacles");
  VoxelMap map;
  ObstacleLayer layer(kArea, 0.05);
  for (int round = 0; round < 4; ++round) {
    for (int i = 0; i < 200; ++i) {
      const Voxel v{static_cast<int>(random.below(60)) - 30, static_cast<int>(random.below(60)) - 20,
                    static_cast<int>(random.below(30)) - 4};
      map.set(v, static_cast<Occupancy>(random.below(3)));
    }
    layer.update(map);
    expect_projected(map, layer);
    RC_ASSERT(!layer.update(map));
  }
}

TEST(ObstacleLayer, CoversTheAreaInTheMapsCells) {
  const ObstacleLayer layer(kArea, 0.05);
  EXPECT_EQ(layer.obstacles().width(), 40);
  EXPECT_EQ(layer.obstacles().height(), 30);
  EXPECT_NEAR((layer.obstacles().origin_m() - kArea.origin_m()).norm(), 0.0, 1e-12);
  EXPECT_EQ(layer.seen_cells(), 0u);
}

TEST(ObstacleLayer, RefusesAnotherResolutionAndHeightsThatAreTurnedRound) {
  ObstacleLayer layer(kArea, 0.1);
  EXPECT_THROW(layer.update(VoxelMap{}), ArgumentError);
  ObstacleLayerParams params;
  params.z_high_m = -1.0;
  EXPECT_THROW(ObstacleLayer(kArea, 0.05, params), ArgumentError);
}

}  // namespace
}  // namespace amiss::mapping
