#include "change/internal/object_fit.hpp"

#include <algorithm>
#include <cmath>

#include "change/internal/nearest_field.hpp"

namespace amiss::change::internal {

namespace {

constexpr std::size_t kSamples = 400;
constexpr int kIterations = 25;
constexpr double kMaxTurnRad = radians(30.0);
constexpr double kClearlyBetter = 0.02;

struct Start {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;
};
constexpr double kStartM = 0.07, kStartRad = 0.2;
constexpr Start kStarts[] = {
    {}, {0, 0, kStartRad}, {0, 0, -kStartRad}, {kStartM, 0, 0}, {-kStartM, 0, 0}, {0, kStartM, 0}, {0, -kStartM, 0}};

/// Planar motion about a centre.
struct Planar {
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  double yaw_rad = 0.0;
  [[nodiscard]] Eigen::Isometry3f about(const Eigen::Vector3f& centre) const {
    const Eigen::Vector3f t(static_cast<float>(shift.x()), static_cast<float>(shift.y()), 0.0F);
    return Eigen::Translation3f(centre + t) * Eigen::AngleAxisf(static_cast<float>(yaw_rad), Eigen::Vector3f::UnitZ()) *
           Eigen::Translation3f(-centre);
  }
};

struct Icp {
  std::vector<Eigen::Vector3f> samples;  // relative to the centre
  Eigen::Vector3f centre;
  const std::vector<Eigen::Vector3f>& reference;
  const NearestField& field;

  [[nodiscard]] Eigen::Vector3f placed(const Eigen::Vector3f& sample, const Planar& m) const {
    const auto c = static_cast<float>(std::cos(m.yaw_rad)), s = static_cast<float>(std::sin(m.yaw_rad));
    return centre + Eigen::Vector3f(c * sample.x() - s * sample.y() + static_cast<float>(m.shift.x()),
                                    s * sample.x() + c * sample.y() + static_cast<float>(m.shift.y()), sample.z());
  }

  /// Least squares in the plane (Horn) over the pairs that are within reach.
  [[nodiscard]] Planar step(const Planar& m, float reach_m) const {
    Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();
    std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> pairs;
    for (const Eigen::Vector3f& sample : samples) {
      const Eigen::Vector3f p = placed(sample, m);
      const auto j = field.nearest(p);
      if (!j || (reference[*j] - p).squaredNorm() > reach_m * reach_m) continue;
      pairs.emplace_back(sample.head<2>().cast<double>(), (reference[*j] - centre).head<2>().cast<double>());
      from += pairs.back().first;
      to += pairs.back().second;
    }
    if (pairs.size() < 3) return m;
    from /= static_cast<double>(pairs.size());
    to /= static_cast<double>(pairs.size());
    double dot = 0.0, cross = 0.0;
    for (const auto& [a, b] : pairs) {
      const Eigen::Vector2d u = a - from, v = b - to;
      dot += u.dot(v);
      cross += u.x() * v.y() - u.y() * v.x();
    }
    Planar next;
    next.yaw_rad = std::clamp(std::atan2(cross, dot), -kMaxTurnRad, kMaxTurnRad);
    next.shift = to - Eigen::Rotation2Dd(next.yaw_rad) * from;
    return next;
  }

  [[nodiscard]] double overlap(const Planar& m, float distance_m) const {
    std::size_t near = 0;
    for (const Eigen::Vector3f& sample : samples) {
      const Eigen::Vector3f p = placed(sample, m);
      const auto j = field.nearest(p);
      if (j && (reference[*j] - p).squaredNorm() <= distance_m * distance_m) ++near;
    }
    return static_cast<double>(near) / static_cast<double>(samples.size());
  }
};

Eigen::Vector3f mean_of(const std::vector<Eigen::Vector3f>& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : points) sum += p.cast<double>();
  return (sum / static_cast<double>(points.size())).cast<float>();
}

NearestField field_of(const std::vector<Eigen::Vector3f>& object, const std::vector<Eigen::Vector3f>& reference,
                      const NovelParams& params) {
  Eigen::Array3f low = object.front(), high = low;
  for (const Eigen::Vector3f& p : object) {
    low = low.min(p.array());
    high = high.max(p.array());
  }
  const auto margin = static_cast<float>(params.reference_margin_m);
  const auto level = static_cast<float>(params.plane_alignment_m);
  const Eigen::Array3f spare(margin, margin, level);
  return {reference, low - spare, high + spare, static_cast<float>(params.object_alignment_m)};
}

}  // namespace

Fit best_fit(const std::vector<Eigen::Vector3f>& object, const std::vector<Eigen::Vector3f>& reference,
             const NovelParams& params) {
  if (object.empty() || reference.empty()) return {};
  const NearestField field = field_of(object, reference, params);
  Icp icp{{}, mean_of(object), reference, field};
  const std::size_t n = std::min(kSamples, object.size());
  for (std::size_t k = 0; k < n; ++k) icp.samples.emplace_back(object[k * object.size() / n] - icp.centre);

  const auto reach = static_cast<float>(params.object_alignment_m), d = static_cast<float>(params.difference_m);
  Fit best;
  best.overlap = -kClearlyBetter;
  for (const Start& start : kStarts) {
    Planar m{{start.x_m, start.y_m}, start.yaw_rad};
    for (int k = 0; k < kIterations; ++k) {
      const float left = 1.0F - static_cast<float>(k) / static_cast<float>(kIterations - 1);
      m = icp.step(m, d + left * (reach - d));
    }
    const double overlap = icp.overlap(m, d);
    if (m.shift.norm() > params.reference_margin_m || overlap < best.overlap + kClearlyBetter) continue;
    best = {m.about(icp.centre), overlap, m.shift.norm(), m.yaw_rad};
  }
  best.overlap = std::max(0.0, best.overlap);
  return best;
}

}  // namespace amiss::change::internal
