#include "semantics/internal/moments.hpp"

#include <Eigen/Eigenvalues>

#include "semantics/parallel.hpp"

namespace amiss::semantics {

namespace {

/// Sums over voxels, positions relative to the middle of the cell.
struct Sums {
  double count = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d colour = Eigen::Vector3d::Zero(), colour_squares = Eigen::Vector3d::Zero();

  void add(const Eigen::Vector3d& p, const Eigen::Vector3d& lab) {
    count += 1;
    position += p;
    squares += p * p.transpose();
    colour += lab;
    colour_squares += lab.cwiseProduct(lab);
  }
  void add(const Sums& other, const Eigen::Vector3d& shift) {
    count += other.count;
    position += other.position + other.count * shift;
    squares += other.squares + shift * other.position.transpose() + other.position * shift.transpose() +
               other.count * shift * shift.transpose();
    colour += other.colour;
    colour_squares += other.colour_squares;
  }
};

Surrounding summary(const Sums& sums, const Eigen::Vector3d& middle) {
  const Eigen::Vector3d mean = sums.position / sums.count;
  const Eigen::Matrix3d covariance = sums.squares / sums.count - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(covariance);
  const Eigen::Vector3d colour = sums.colour / sums.count;
  Surrounding s;
  s.voxels = static_cast<float>(sums.count);
  s.mean = (middle + mean).cast<float>();
  s.normal = axes.eigenvectors().col(0).cast<float>();
  s.variances = axes.eigenvalues().cwiseMax(0.0).cast<float>();
  s.variance_z = static_cast<float>(std::max(covariance(2, 2), 0.0));
  s.colour = colour.cast<float>();
  s.colour_deviation =
      (sums.colour_squares / sums.count - colour.cwiseProduct(colour)).cwiseMax(0.0).cwiseSqrt().cast<float>();
  return s;
}

}  // namespace

Surroundings surroundings_of(const Voxels& voxels, double cell_m, int threads) {
  Surroundings result;
  CellIndex index;
  std::vector<Eigen::Vector3i> cells;
  std::vector<Sums> sums;
  const auto middle_of = [&](const Eigen::Vector3i& cell) {
    return Eigen::Vector3d((cell.cast<double>().array() + 0.5) * cell_m);
  };
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    const Eigen::Vector3i cell = cell_of(voxels.positions[v], cell_m);
    const std::uint32_t c = index.at_or_put(cell_key(cell), static_cast<std::uint32_t>(cells.size()));
    if (c == cells.size()) {
      cells.push_back(cell);
      sums.emplace_back();
    }
    result.of_voxel.push_back(c);
    sums[c].add(voxels.positions[v].cast<double>() - middle_of(cell), voxels.colours[v].cast<double>());
  }
  result.cells.resize(cells.size());
  in_parallel(cells.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      Sums around;
      for_neighbours([&](const Eigen::Vector3i& offset) {
        const std::uint32_t other = index.at(cell_key(cells[c] + offset));
        if (other != CellIndex::kNone) around.add(sums[other], offset.cast<double>() * cell_m);
      });
      result.cells[c] = summary(around, middle_of(cells[c]));
    }
  });
  return result;
}

}  // namespace amiss::semantics
