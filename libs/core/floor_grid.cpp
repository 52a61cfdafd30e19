#include "core/floor_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/line_cells.hpp"

namespace amiss {

FloorGrid::FloorGrid(double resolution_m, Eigen::Vector2d origin_m, int width, int height, Occupancy fill)
    : resolution_m_(resolution_m),
      origin_m_(std::move(origin_m)),
      width_(width),
      height_(height),
      cells_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {}

Cell FloorGrid::cell_at(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2d scaled = (p_map - origin_m_) / resolution_m_;
  return {static_cast<int>(std::floor(scaled.x())), static_cast<int>(std::floor(scaled.y()))};
}

Eigen::Vector2d FloorGrid::centre_of(Cell c) const {
  return origin_m_ + resolution_m_ * Eigen::Vector2d(c.x + 0.5, c.y + 0.5);
}

FloorGrid dilated(const FloorGrid& grid, int radius_cells) {
  FloorGrid grown = grid;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (grid.at(Cell{x, y}) != Occupancy::kOccupied) continue;
      for (int ny = std::max(0, y - radius_cells); ny <= std::min(grid.height() - 1, y + radius_cells); ++ny) {
        for (int nx = std::max(0, x - radius_cells); nx <= std::min(grid.width() - 1, x + radius_cells); ++nx) {
          grown.set({nx, ny}, Occupancy::kOccupied);
        }
      }
    }
  }
  return grown;
}

namespace {

constexpr float kFar = 1e12F;

/// Squared distances along one line: the lower envelope of the parabolas rooted at each sample.
class LineTransform {
 public:
  explicit LineTransform(std::size_t longest) : roots_(longest), borders_(longest + 1), input_(longest) {}

  void run(float* values, std::size_t n, std::size_t stride) {
    for (std::size_t i = 0; i < n; ++i) input_[i] = values[i * stride];
    std::size_t k = 0;
    roots_[0] = 0;
    borders_[0] = -std::numeric_limits<float>::infinity();
    borders_[1] = std::numeric_limits<float>::infinity();
    for (std::size_t q = 1; q < n; ++q) {
      float border = crossing(q, roots_[k]);
      while (border <= borders_[k]) border = crossing(q, roots_[--k]);
      roots_[++k] = q;
      borders_[k] = border;
      borders_[k + 1] = std::numeric_limits<float>::infinity();
    }
    k = 0;
    for (std::size_t q = 0; q < n; ++q) {
      while (borders_[k + 1] < static_cast<float>(q)) ++k;
      const float offset = static_cast<float>(q) - static_cast<float>(roots_[k]);
      values[q * stride] = offset * offset + input_[roots_[k]];
    }
  }

 private:
  [[nodiscard]] float crossing(std::size_t q, std::size_t p) const {
    const auto fq = static_cast<float>(q), fp = static_cast<float>(p);
    return ((input_[q] + fq * fq) - (input_[p] + fp * fp)) / (2.0F * (fq - fp));
  }

  std::vector<std::size_t> roots_;
  std::vector<float> borders_;
  std::vector<float> input_;
};

}  // namespace

std::vector<float> distance_to_occupied_m(const FloorGrid& grid, bool unknown_is_occupied) {
  const auto width = static_cast<std::size_t>(grid.width());
  const auto height = static_cast<std::size_t>(grid.height());
  std::vector<float> distance(width * height, kFar);
  for (std::size_t i = 0; i < distance.size(); ++i) {
    const Occupancy value = grid.cells()[i];
    if (value == Occupancy::kOccupied || (unknown_is_occupied && value == Occupancy::kUnknown)) distance[i] = 0.0F;
  }
  if (distance.empty()) return distance;
  LineTransform transform(std::max(width, height));
  for (std::size_t x = 0; x < width; ++x) transform.run(distance.data() + x, height, width);
  for (std::size_t y = 0; y < height; ++y) transform.run(distance.data() + y * width, width, 1);
  const auto resolution = static_cast<float>(grid.resolution_m());
  for (float& d : distance) d = std::sqrt(d) * resolution;
  return distance;
}

bool line_of_sight(const FloorGrid& grid, const Eigen::Vector2d& a_map, const Eigen::Vector2d& b_map) {
  return for_line_cells(grid, a_map, b_map,
                        [&grid](Cell cell, double, double) { return grid.at(cell) == Occupancy::kFree; });
}

}  // namespace amiss
