#include "sim/internal/segment_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace amiss::sim::internal {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr int kMaxCells = 1024;    // along one axis; larger worlds get larger cells
constexpr double kSlack_m = 1e-6;  // segments on the border of a cell belong to both neighbours

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The part of a ray inside of a box, empty when first > second.
std::pair<double, double> clip(const Eigen::Vector2d& origin, const Eigen::Vector2d& inverse,
                               const Eigen::Vector2d& low, const Eigen::Vector2d& high, double max_m) {
  double enter = 0.0, leave = max_m;
  for (int axis = 0; axis < 2; ++axis) {
    if (std::isinf(inverse[axis])) {
      if (origin[axis] < low[axis] || origin[axis] > high[axis]) return {1.0, 0.0};
      continue;
    }
    const double a = (low[axis] - origin[axis]) * inverse[axis], b = (high[axis] - origin[axis]) * inverse[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return {enter, leave};
}

}  // namespace

double hit(const Segment2& segment, const Eigen::Vector2d& origin, const Eigen::Vector2d& direction) {
  const Eigen::Vector2d extent = segment.b - segment.a, to_start = segment.a - origin;
  const double area = cross(direction, extent);
  if (area == 0.0) return kNever;
  const double along = cross(to_start, direction) / area;
  const double range = cross(to_start, extent) / area;
  return along >= 0.0 && along <= 1.0 && range >= 0.0 ? range : kNever;
}

SegmentGrid::SegmentGrid(const std::vector<Segment2>& segments) {
  if (segments.empty()) return;
  Eigen::AlignedBox2d box;
  for (const Segment2& s : segments) box.extend(s.a).extend(s.b);
  low_ = box.min().array() - 0.01;
  high_ = box.max().array() + 0.01;
  cell_m_ = std::max(cell_m_, (high_ - low_).maxCoeff() / kMaxCells);
  width_ = static_cast<int>((high_.x() - low_.x()) / cell_m_) + 1;
  height_ = static_cast<int>((high_.y() - low_.y()) / cell_m_) + 1;

  std::vector<std::vector<std::uint32_t>> cells(segments.size());
  first_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) + 1, 0);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    cells[i] = cells_of(segments[i]);
    for (const std::uint32_t cell : cells[i]) ++first_[cell + 1];
  }
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  stored_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment2& s = segments[i];
    for (const std::uint32_t cell : cells[i]) {
      stored_[next[cell]++] = {s.a.x(), s.a.y(), s.b.x() - s.a.x(), s.b.y() - s.a.y()};
    }
  }
}

std::vector<std::uint32_t> SegmentGrid::cells_of(const Segment2& segment) const {
  const Eigen::Vector2d a = segment.a.cwiseMin(segment.b), b = segment.a.cwiseMax(segment.b);
  const auto cell = [&](double value, double low) { return static_cast<int>((value - low) / cell_m_); };
  const Eigen::Vector2d extent = segment.b - segment.a;
  std::vector<std::uint32_t> out;
  for (int y = cell(a.y() - kSlack_m, low_.y()); y <= std::min(height_ - 1, cell(b.y() + kSlack_m, low_.y())); ++y) {
    for (int x = cell(a.x() - kSlack_m, low_.x()); x <= std::min(width_ - 1, cell(b.x() + kSlack_m, low_.x())); ++x) {
      // The cell is crossed when its corners do not all lie on one side of the segment's line.
      const Eigen::Vector2d middle = low_ + cell_m_ * Eigen::Vector2d(x + 0.5, y + 0.5);
      const double reach = (0.5 * cell_m_ + kSlack_m) * (std::abs(extent.x()) + std::abs(extent.y()));
      if (std::abs(cross(extent, middle - segment.a)) > reach) continue;
      out.push_back(static_cast<std::uint32_t>(y * width_ + x));
    }
  }
  return out;
}

double SegmentGrid::cast(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction, double max_m) const {
  if (stored_.empty()) return kNever;
  const Eigen::Vector2d inverse = direction.cwiseInverse();
  const auto [enter, leave] = clip(origin, inverse, low_, high_, max_m);
  if (enter > leave) return kNever;
  const Eigen::Vector2d start = origin + enter * direction;
  int x = std::clamp(static_cast<int>((start.x() - low_.x()) / cell_m_), 0, width_ - 1);
  int y = std::clamp(static_cast<int>((start.y() - low_.y()) / cell_m_), 0, height_ - 1);
  const int step_x = direction.x() >= 0.0 ? 1 : -1, step_y = direction.y() >= 0.0 ? 1 : -1;
  double next_x = (low_.x() + cell_m_ * (x + (step_x > 0 ? 1 : 0)) - origin.x()) * inverse.x();
  double next_y = (low_.y() + cell_m_ * (y + (step_y > 0 ? 1 : 0)) - origin.y()) * inverse.y();
  if (std::isinf(inverse.x())) next_x = kNever;
  if (std::isinf(inverse.y())) next_y = kNever;
  const double delta_x = cell_m_ * std::abs(inverse.x()), delta_y = cell_m_ * std::abs(inverse.y());

  double best = kNever;
  while (x >= 0 && y >= 0 && x < width_ && y < height_) {
    const auto cell = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
      const Stored& s = stored_[i];
      const double to_x = s.ax - origin.x(), to_y = s.ay - origin.y();
      const double area = direction.x() * s.ey - direction.y() * s.ex;
      if (area == 0.0) continue;
      const double scale = 1.0 / area;
      const double along = (to_x * direction.y() - to_y * direction.x()) * scale;
      const double range = (to_x * s.ey - to_y * s.ex) * scale;
      if (along >= 0.0 && along <= 1.0 && range >= 0.0 && range < best) best = range;
    }
    const double end_of_cell = std::min(next_x, next_y);
    if (best <= end_of_cell || end_of_cell > leave) break;
    if (next_x < next_y) {
      x += step_x;
      next_x += delta_x;
    } else {
      y += step_y;
      next_y += delta_y;
    }
  }
  return best <= max_m ? best : kNever;
}

}  // namespace amiss::sim::internal
