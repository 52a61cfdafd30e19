#include "localize/internal/mrpt_types.hpp"

#include <algorithm>

namespace amiss::localize::internal {

bool valid_range(const LaserScan& scan, std::size_t i) {
  const double range_m = static_cast<double>(scan.ranges_m[i]);
  return std::isfinite(range_m) && range_m >= scan.min_range_m && range_m <= scan.max_range_m;
}

mrpt::obs::CObservation2DRangeScan::Ptr to_mrpt(const LaserScan& scan, const Transform<Base, Laser>& T_base_laser,
                                                int max_beams) {
  const std::size_t beams = scan.ranges_m.size();
  const auto wanted = static_cast<std::size_t>(std::max(2, max_beams));
  const std::size_t step = std::max<std::size_t>(1, (beams + wanted - 1) / wanted);
  const std::size_t kept = beams == 0 ? 0 : (beams - 1) / step + 1;

  auto out = mrpt::obs::CObservation2DRangeScan::Create();
  // MRPT spreads the beams evenly and symmetrically over `aperture`; the middle of ours goes into the sensor's pose.
  const double aperture_rad = kept < 2 ? 0.0 : scan.angle_step_rad * static_cast<double>(step * (kept - 1));
  out->aperture = static_cast<float>(std::abs(aperture_rad));
  out->rightToLeft = aperture_rad >= 0.0;
  out->maxRange = static_cast<float>(scan.max_range_m);
  Eigen::Isometry3d T = T_base_laser.T;
  T.rotate(Eigen::AngleAxisd(scan.angle_min_rad + aperture_rad / 2.0, Eigen::Vector3d::UnitZ()));
  const Eigen::Matrix3d R = T.rotation();
  mrpt::math::CMatrixDouble33 rotation;
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) rotation(row, col) = R(row, col);
  }
  out->sensorPose = mrpt::poses::CPose3D(
      rotation, mrpt::math::TPoint3D(T.translation().x(), T.translation().y(), T.translation().z()));
  out->resizeScan(kept);
  for (std::size_t k = 0; k < kept; ++k) {
    const bool valid = valid_range(scan, k * step);
    out->setScanRange(k, valid ? scan.ranges_m[k * step] : 0.0F);
    out->setScanRangeValidity(k, valid);
  }
  return out;
}

mrpt::maps::COccupancyGridMap2D::Ptr to_mrpt(const FloorGrid& grid) {
  const auto res = static_cast<float>(grid.resolution_m());
  auto out = mrpt::maps::COccupancyGridMap2D::Create();
  out->setSize(0.0F, static_cast<float>(grid.width()) * res, 0.0F, static_cast<float>(grid.height()) * res, res, 0.5F);
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const Occupancy cell = grid.at(Cell{x, y});
      if (cell != Occupancy::kUnknown) out->setCell(x, y, cell == Occupancy::kFree ? 0.99F : 0.01F);
    }
  }
  return out;
}

}  // namespace amiss::localize::internal
