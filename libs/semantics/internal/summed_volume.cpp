#include "semantics/internal/summed_volume.hpp"

#include <string>

#include "core/result.hpp"

namespace amiss::semantics {

namespace {
constexpr double kMostCells = 1.5e8;
}

SummedVolume::SummedVolume(const Eigen::Vector3i& size) : size_(size) {
  const Eigen::Vector3d cells = size.cast<double>() + Eigen::Vector3d::Ones();
  if ((size.array() < 1).any() || cells.prod() > kMostCells) {
    throw ArgumentError("a cloud to be labelled: its points spread over " + std::to_string(size.x()) + " x " +
                        std::to_string(size.y()) + " cells of the floor; at most " +
                        std::to_string(static_cast<int>(kMostCells / cells.z())) +
                        " are allowed (is it in metres, without far outliers?)");
  }
  sums_.assign(static_cast<std::size_t>(cells.prod()), 0);
}

void SummedVolume::sum_up() {
  for (int x = 1; x <= size_.x(); ++x) {
    for (int y = 1; y <= size_.y(); ++y) {
      std::int32_t column = 0;
      for (int z = 1; z <= size_.z(); ++z) {
        column += sums_[place(x, y, z)];
        sums_[place(x, y, z)] =
            column + sums_[place(x - 1, y, z)] + sums_[place(x, y - 1, z)] - sums_[place(x - 1, y - 1, z)];
      }
    }
  }
}

}  // namespace amiss::semantics
