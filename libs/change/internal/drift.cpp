#include "change/internal/drift.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace amiss::change::internal {

namespace {

constexpr float kCellM = 0.5F;
constexpr std::size_t kWholeSamples = 4000, kCellSamples = 300;
constexpr float kFinalReachM = 0.02F;
constexpr int kIterations = 8;
constexpr float kMinNormalDot = 0.85F;
constexpr double kPriorShare = 0.15;   // of the samples: how many of them the motion of the whole room counts as
constexpr double kPriorTurnM2 = 0.25;  // lever of the prior about z

using Vector4d = Eigen::Matrix<double, 4, 1>;
using Matrix4d = Eigen::Matrix<double, 4, 4>;

segment::Indices evenly(const segment::Indices& among, std::size_t most) {
  if (among.size() <= most) return among;
  segment::Indices some;
  some.reserve(most);
  for (std::size_t k = 0; k < most; ++k) some.push_back(among[k * among.size() / most]);
  return some;
}

struct Motion {
  const ThinnedScene& reference;
  const ThinnedScene& current;

  /// The reference's point that belongs to p: near, and with a like normal.
  [[nodiscard]] std::optional<std::uint32_t> partner(const Eigen::Vector3f& p, const Eigen::Vector3f& normal,
                                                     float reach_m) const {
    const auto found = reference.grid.nearest_of(
        p, reach_m, [&](std::uint32_t j) { return std::abs(reference.normals[j].dot(normal)) >= kMinNormalDot; });
    return found ? std::optional(found->index) : std::nullopt;
  }

  /// One step from T about `centre` (reference frame); `held` is the weight that keeps it at `prior`.
  [[nodiscard]] Eigen::Isometry3f step(const Eigen::Isometry3f& T, const segment::Indices& samples, float reach_m,
                                       double held) const {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    for (const std::uint32_t i : samples) centre += current.points[i] / static_cast<float>(samples.size());
    centre = T * centre;
    Matrix4d H = Matrix4d::Zero();
    Vector4d g = Vector4d::Zero();
    for (const std::uint32_t i : samples) {
      const Eigen::Vector3f p = T * current.points[i];
      const Eigen::Vector3f normal = T.linear() * current.normals[i];
      const auto j = partner(p, normal, reach_m);
      if (!j) continue;
      const Eigen::Vector3d n = reference.normals[*j].cast<double>();
      const Eigen::Vector3d lever = (p - centre).cast<double>();
      const double residual = n.dot((reference.points[*j] - p).cast<double>());
      const double inner = 1.0 - std::pow(residual / static_cast<double>(reach_m), 2);
      const double weight = inner * inner;
      Vector4d row;
      row << n, n.y() * lever.x() - n.x() * lever.y();
      H += weight * row * row.transpose();
      g += weight * residual * row;
    }
    Vector4d prior = Vector4d::Constant(held);
    prior[3] *= kPriorTurnM2;
    H.diagonal() += prior + Vector4d::Constant(1e-9);
    const Vector4d x = H.ldlt().solve(g);
    const Eigen::Vector3f shift = x.head<3>().cast<float>();
    return Eigen::Translation3f(shift + centre) *
           Eigen::AngleAxisf(static_cast<float>(x[3]), Eigen::Vector3f::UnitZ()) * Eigen::Translation3f(-centre) * T;
  }

  [[nodiscard]] Eigen::Isometry3f aligned(Eigen::Isometry3f T, const segment::Indices& samples, float reach_m,
                                          double prior_share) const {
    if (samples.empty()) return T;
    const double held = prior_share * static_cast<double>(samples.size());
    for (int k = 0; k < kIterations; ++k) {
      const float left = 1.0F - static_cast<float>(k) / static_cast<float>(kIterations - 1);
      T = step(T, samples, kFinalReachM + left * std::max(0.0F, reach_m - kFinalReachM), held);
    }
    return T;
  }
};

}  // namespace

Drift::Cell Drift::cell_of(const Eigen::Vector3f& p) {
  return {static_cast<int>(std::floor(p.x() / kCellM)), static_cast<int>(std::floor(p.y() / kCellM))};
}

Drift::Drift(const ThinnedScene& reference, const ThinnedScene& current, double reach_m) {
  const Motion motion{reference, current};
  segment::Indices all;
  std::map<Cell, segment::Indices> windows;  // of each cell and its 8 neighbours
  for (std::uint32_t i = 0; i < current.points.size(); ++i) {
    if (current.normals[i].isZero()) continue;
    all.push_back(i);
    const Cell cell = cell_of(current.points[i]);
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) windows[{cell.first + dx, cell.second + dy}].push_back(i);
    }
  }
  whole_ = motion.aligned(whole_, evenly(all, kWholeSamples), static_cast<float>(reach_m), 0.0);
  for (const auto& [cell, window] : windows) {
    local_[cell] =
        motion.aligned(whole_, evenly(window, kCellSamples), 0.5F * static_cast<float>(reach_m), kPriorShare);
  }
}

const Eigen::Isometry3f& Drift::at(const Eigen::Vector3f& p) const {
  const auto found = local_.find(cell_of(p));
  return found == local_.end() ? whole_ : found->second;
}

}  // namespace amiss::change::internal
