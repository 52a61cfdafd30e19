#include "localize/internal/grid_drawing.hpp"

#include <cmath>
#include <limits>

#include "localize/internal/mrpt_types.hpp"

namespace amiss::localize::internal {

namespace {

constexpr int kAllBeams = std::numeric_limits<int>::max();
constexpr float kOccupiedCertainty = 0.75F;
constexpr float kFreeCertainty = 0.58F;
constexpr float kFreeAbove = 0.55F;  // probability of being free
constexpr float kOccupiedBelow = 0.45F;

}  // namespace

DrawnGrid::DrawnGrid(double resolution_m, double max_range_m)
    : resolution_m_(resolution_m), grid_(-1.0F, 1.0F, -1.0F, 1.0F, static_cast<float>(resolution_m)) {
  grid_.insertionOptions.maxDistanceInsertion = static_cast<float>(max_range_m);
  grid_.insertionOptions.maxOccupancyUpdateCertainty = kOccupiedCertainty;
  grid_.insertionOptions.maxFreenessUpdateCertainty = kFreeCertainty;
  grid_.insertionOptions.considerInvalidRangesAsFreeSpace = false;
}

void DrawnGrid::add(const LaserScan& scan, const Transform<Base, Laser>& T_base_laser,
                    const Pose2<Map, Base>& T_map_base) {
  const mrpt::poses::CPose3D pose(to_mrpt(T_map_base));
  grid_.insertObservation(*to_mrpt(scan, T_base_laser, kAllBeams), pose);
  floor_.reset();
}

const FloorGrid& DrawnGrid::floor() {
  if (floor_) return *floor_;
  // MRPT keeps its corner at a multiple of the resolution, in single precision.
  const auto corner_m = [this](float corner) {
    return resolution_m_ * std::round(static_cast<double>(corner) / resolution_m_);
  };
  FloorGrid floor(resolution_m_, {corner_m(grid_.getXMin()), corner_m(grid_.getYMin())},
                  static_cast<int>(grid_.getSizeX()), static_cast<int>(grid_.getSizeY()));
  for (int y = 0; y < floor.height(); ++y) {
    for (int x = 0; x < floor.width(); ++x) {
      const float free = grid_.getCell(x, y);
      if (free > kFreeAbove) floor.set({x, y}, Occupancy::kFree);
      if (free < kOccupiedBelow) floor.set({x, y}, Occupancy::kOccupied);
    }
  }
  floor_ = std::move(floor);
  return *floor_;
}

}  // namespace amiss::localize::internal
