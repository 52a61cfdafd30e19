#include "view/internal/triangle_view.hpp"

#include <algorithm>
#include <cmath>

namespace amiss::view::internal {
namespace {

constexpr int kBins = 4096;  // directions

int bin_of(double angle_rad) {
  const double turn = angle_rad / (2.0 * std::numbers::pi);
  return static_cast<int>(std::floor((turn - std::floor(turn)) * kBins)) % kBins;
}

}  // namespace

TriangleView::TriangleView(const FloorGrid& sight, double angle_rad, double height_m)
    : sight_(sight), slope_(std::tan(0.5 * angle_rad)), height_m_(height_m), shadow_(kBins, 0) {
  const double res = sight.resolution_m();
  const double side_m = height_m * std::hypot(1.0, slope_) + 2.0 * res;
  const int reach = static_cast<int>(std::ceil(side_m / res));
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      if (std::hypot(dx, dy) * res > side_m) continue;
      const double angle = std::atan2(dy, dx);
      double low = 0.0, high = 0.0;  // of the corners, against the centre
      for (const double cx : {-0.5, 0.5}) {
        for (const double cy : {-0.5, 0.5}) {
          const double corner = wrap_angle(std::atan2(dy + cy, dx + cx) - angle);
          low = std::min(low, corner);
          high = std::max(high, corner);
        }
      }
      const int first = bin_of(angle + low);
      const int count = std::min(kBins, static_cast<int>(std::ceil((high - low) / (2.0 * std::numbers::pi) * kBins)));
      offsets_.push_back({static_cast<std::int16_t>(dx), static_cast<std::int16_t>(dy), static_cast<float>(dx * res),
                          static_cast<float>(dy * res), dy * sight.width() + dx,
                          static_cast<std::uint16_t>(bin_of(angle)), static_cast<std::uint16_t>(first),
                          static_cast<std::uint16_t>(count)});
    }
  }
  std::stable_sort(offsets_.begin(), offsets_.end(), [](const Offset& a, const Offset& b) {
    return a.dx * a.dx + a.dy * a.dy < b.dx * b.dx + b.dy * b.dy;
  });
}

const std::vector<std::uint32_t>& TriangleView::from(const Pose2<Map, Base>& T_map_base) {
  seen_.clear();
  const Cell apex = sight_.cell_at(T_map_base.position());
  if (sight_.at(apex) != Occupancy::kFree) return seen_;
  std::fill(shadow_.begin(), shadow_.end(), std::uint8_t{0});
  const Eigen::Vector2f shift = (sight_.centre_of(apex) - T_map_base.position()).cast<float>();
  const auto c = static_cast<float>(std::cos(T_map_base.yaw_rad)), s = static_cast<float>(std::sin(T_map_base.yaw_rad));
  const auto slope = static_cast<float>(slope_), height = static_cast<float>(height_m_);
  const auto border = static_cast<float>(2.0 * sight_.resolution_m());  // cells outside that may cast shadows inside
  const auto at_apex = static_cast<std::int32_t>(sight_.index(apex));
  for (const Offset& o : offsets_) {
    const float dx = o.x_m + shift.x(), dy = o.y_m + shift.y();
    const float x = c * dx + s * dy, y = std::abs(c * dy - s * dx);
    if (x > height || y > slope * x + border) continue;
    const Cell cell{apex.x + o.dx, apex.y + o.dy};
    if (!sight_.contains(cell)) continue;
    const auto index = static_cast<std::uint32_t>(at_apex + o.index);
    if (sight_.cells()[index] != Occupancy::kFree) {
      for (int i = 0; i < o.count; ++i) shadow_[static_cast<std::size_t>((o.first + i) % kBins)] = 1;
    } else if (x >= 0.0F && y <= slope * x && shadow_[o.bin] == 0) {
      seen_.push_back(index);
    }
  }
  return seen_;
}

}  // namespace amiss::view::internal
