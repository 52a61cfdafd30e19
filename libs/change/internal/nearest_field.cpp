#include "change/internal/nearest_field.hpp"

#include <cmath>

namespace amiss::change::internal {

namespace {

constexpr float kCellM = 0.01F;
constexpr std::uint32_t kNone = 0xffffffffU;

}  // namespace

NearestField::NearestField(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& low,
                           const Eigen::Vector3f& high, float reach_m)
    : low_(low) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    size_[k] = static_cast<int>(std::ceil((high[axis] - low[axis]) / kCellM)) + 1;
  }
  nearest_.assign(
      static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) * static_cast<std::size_t>(size_[2]),
      kNone);
  std::vector<Cell> front;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Cell c = cell_of(points[i]);
    if (!inside(c) || nearest_[index(c)] != kNone) continue;
    nearest_[index(c)] = i;
    front.push_back(c);
  }
  spread(points, std::move(front), static_cast<int>(std::ceil(reach_m / kCellM)));
}

void NearestField::spread(const std::vector<Eigen::Vector3f>& points, std::vector<Cell> front, int rings) {
  for (int ring = 0; ring < rings && !front.empty(); ++ring) {
    std::vector<Cell> next;
    for (const Cell& c : front) {
      const std::uint32_t here = nearest_[index(c)];
      for (int k = 0; k < 27; ++k) {
        const Cell n{c[0] + k % 3 - 1, c[1] + k / 3 % 3 - 1, c[2] + k / 9 - 1};
        if (!inside(n)) continue;
        std::uint32_t& there = nearest_[index(n)];
        if (there == here) continue;
        const Eigen::Vector3f centre = centre_of(n);
        if (there == kNone) {
          next.push_back(n);
        } else if ((points[there] - centre).squaredNorm() <= (points[here] - centre).squaredNorm()) {
          continue;
        }
        there = here;
      }
    }
    front = std::move(next);
  }
}

NearestField::Cell NearestField::cell_of(const Eigen::Vector3f& p) const {
  const Eigen::Array3f c = ((p - low_).array() / kCellM).floor();
  return {static_cast<int>(c.x()), static_cast<int>(c.y()), static_cast<int>(c.z())};
}

bool NearestField::inside(const Cell& c) const {
  return c[0] >= 0 && c[1] >= 0 && c[2] >= 0 && c[0] < size_[0] && c[1] < size_[1] && c[2] < size_[2];
}

std::size_t NearestField::index(const Cell& c) const {
  const auto part = [](int v) { return static_cast<std::size_t>(v); };
  return (part(c[2]) * part(size_[1]) + part(c[1])) * part(size_[0]) + part(c[0]);
}

Eigen::Vector3f NearestField::centre_of(const Cell& c) const {
  return low_ +
         kCellM * (Eigen::Vector3f(static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])) +
                   Eigen::Vector3f::Constant(0.5F));
}

std::optional<std::uint32_t> NearestField::nearest(const Eigen::Vector3f& p) const {
  const Cell c = cell_of(p);
  if (!inside(c) || nearest_[index(c)] == kNone) return std::nullopt;
  return nearest_[index(c)];
}

}  // namespace amiss::change::internal
