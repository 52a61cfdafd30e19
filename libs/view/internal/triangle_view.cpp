#include "view/internal/triangle_view.hpp"

#include <algorithm>
#include <cmath>

namespace amiss::view::internal {
namespace {

constexpr int kBins = 4096;   // directions
constexpr int kSectors = 32;  // of the circle, looked into one by one
constexpr int kBinsInSector = kBins / kSectors;

int bin_of(double angle_rad) {
  const double turn = angle_rad / (2.0 * std::numbers::pi);
  return static_cast<int>(std::floor((turn - std::floor(turn)) * kBins)) % kBins;
}

/// How far the corners of a cell reach to both sides of its middle, seen from the apex.
std::pair<double, double> extent_rad(int dx, int dy, double middle_rad) {
  double low = 0.0, high = 0.0;
  for (const double cx : {-0.5, 0.5}) {
    for (const double cy : {-0.5, 0.5}) {
      const double corner = wrap_angle(std::atan2(dy + cy, dx + cx) - middle_rad);
      low = std::min(low, corner);
      high = std::max(high, corner);
    }
  }
  return {low, high};
}

}  // namespace

TriangleView::TriangleView(const FloorGrid& sight, double angle_rad, double height_m)
    : sight_(sight),
      half_angle_rad_(0.5 * angle_rad),
      slope_(static_cast<float>(std::tan(0.5 * angle_rad))),
      height_m_(static_cast<float>(height_m)),
      sectors_(kSectors),
      shadow_(kBins, 0) {
  const double res = sight.resolution_m();
  const double side_m = height_m / std::cos(half_angle_rad_) + res;
  const int reach = static_cast<int>(std::ceil(side_m / res));
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      if ((dx == 0 && dy == 0) || std::hypot(dx, dy) * res > side_m) continue;
      const double angle = std::atan2(dy, dx);
      const auto [low, high] = extent_rad(dx, dy, angle);
      const int first = bin_of(angle + low);
      const int count = static_cast<int>(std::ceil((high - low) / (2.0 * std::numbers::pi) * kBins));
      const Offset offset{static_cast<std::int16_t>(dx),     static_cast<std::int16_t>(dy),
                          static_cast<float>(dx * res),      static_cast<float>(dy * res),
                          dy * sight.width() + dx,           static_cast<std::uint16_t>(bin_of(angle)),
                          static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(count)};
      for (int s = first / kBinsInSector; s <= (first + count) / kBinsInSector; ++s) {
        sectors_[static_cast<std::size_t>(s % kSectors)].push_back(offset);
      }
    }
  }
  for (auto& sector : sectors_) {
    std::stable_sort(sector.begin(), sector.end(), [](const Offset& a, const Offset& b) {
      return a.dx * a.dx + a.dy * a.dy < b.dx * b.dx + b.dy * b.dy;
    });
  }
}

const std::vector<std::uint32_t>& TriangleView::from(const Pose2<Map, Base>& T_map_base) {
  seen_.clear();
  const Cell apex = sight_.cell_at(T_map_base.position());
  if (sight_.at(apex) != Occupancy::kFree) return seen_;
  std::fill(shadow_.begin(), shadow_.end(), std::uint8_t{0});
  seen_.push_back(static_cast<std::uint32_t>(sight_.index(apex)));
  const auto cosine = static_cast<float>(std::cos(T_map_base.yaw_rad));
  const auto sine = static_cast<float>(std::sin(T_map_base.yaw_rad));
  const int first = bin_of(T_map_base.yaw_rad - half_angle_rad_) / kBinsInSector;
  const int last = bin_of(T_map_base.yaw_rad + half_angle_rad_) / kBinsInSector;
  const int sectors = (last - first + kSectors) % kSectors + 1;
  for (int i = 0; i < sectors; ++i) look_into(static_cast<std::size_t>((first + i) % kSectors), apex, cosine, sine);
  return seen_;
}

void TriangleView::look_into(std::size_t sector, Cell apex, float cosine, float sine) {
  const auto at_apex = static_cast<std::int32_t>(sight_.index(apex));
  for (const Offset& o : sectors_[sector]) {
    const Cell cell{apex.x + o.dx, apex.y + o.dy};
    if (!sight_.contains(cell)) continue;
    const auto index = static_cast<std::uint32_t>(at_apex + o.index);
    if (sight_.cells()[index] != Occupancy::kFree) {
      // Its shadow in the other sectors falls when they are looked into, in their order of distance.
      const int begin = o.first - static_cast<int>(sector) * kBinsInSector;
      const int from = begin > kBins / 2 ? begin - kBins : begin < -kBins / 2 ? begin + kBins : begin;
      const int to = std::min(kBinsInSector, from + o.count);
      for (int i = std::max(0, from); i < to; ++i) {
        shadow_[sector * static_cast<std::size_t>(kBinsInSector) + static_cast<std::size_t>(i)] = 1;
      }
      continue;
    }
    const float x = cosine * o.x_m + sine * o.y_m, y = std::abs(cosine * o.y_m - sine * o.x_m);
    const bool inside = x <= height_m_ && y <= slope_ * x;
    if (inside && shadow_[o.bin] == 0 && o.bin / kBinsInSector == static_cast<int>(sector)) seen_.push_back(index);
  }
}

}  // namespace amiss::view::internal
