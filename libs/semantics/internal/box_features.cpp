#include "semantics/internal/box_features.hpp"

#include <array>
#include <cmath>

namespace amiss::semantics {

namespace {

constexpr double kLow_m = -0.2, kHigh_m = 2.8;  // what is lower or higher counts at the edge
constexpr float kLevelNormal = 0.7F;
constexpr int kCellEdge = 2;  // voxels of the floor plan in a cell
constexpr std::array<int, 3> kNearHalfWidths{1, 3, 8}, kStandingHalfWidths{3, 8, 16};  // cells beside the middle one
constexpr std::array<double, 10> kNearEdges_m{-1.0, -0.4, -0.2, -0.1, -0.04, 0.06, 0.12, 0.22, 0.42, 1.02};
constexpr std::array<double, 11> kStandingEdges_m{-0.2, 0.06, 0.2, 0.4, 0.6, 0.8, 1.0, 1.3, 1.7, 2.3, 2.8};
constexpr int kSupportHalfWidth = 3, kWideHalfWidth = 8;
constexpr float kSupportPart = 0.4F;

static_assert(BoxFeatures::kCount == 2 * (kNearHalfWidths.size() * (kNearEdges_m.size() - 1) +
                                          kStandingHalfWidths.size() * (kStandingEdges_m.size() - 1)) +
                                         5);

int layer_of(double z_m, double edge_m) { return static_cast<int>(std::lround(z_m / edge_m)); }

Eigen::Vector3i lowest(const Voxels& voxels) {
  Eigen::Vector3i low = voxels.cells.front();
  for (const Eigen::Vector3i& cell : voxels.cells) low = low.cwiseMin(cell);
  low.z() = layer_of(kLow_m, voxels.edge_m);
  return low;
}

Eigen::Vector3i extent(const Voxels& voxels, const Eigen::Vector3i& low) {
  Eigen::Vector3i high = voxels.cells.front();
  for (const Eigen::Vector3i& cell : voxels.cells) high = high.cwiseMax(cell);
  return {(high.x() - low.x()) / kCellEdge + 1, (high.y() - low.y()) / kCellEdge + 1,
          layer_of(kHigh_m, voxels.edge_m) - low.z()};
}

float part(int cells, int half_width) {
  const int edge = 2 * half_width + 1;
  return static_cast<float>(cells) / static_cast<float>(edge * edge);
}

}  // namespace

BoxFeatures::BoxFeatures(const Voxels& voxels)
    : voxels_(voxels), low_(lowest(voxels)), surface_(extent(voxels, low_)), level_(surface_.size()) {
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    const Eigen::Vector3i cell = box_cell_of(v);
    surface_.set(cell);
    if (voxels.normals[v].z() > kLevelNormal) level_.set(cell);
  }
  surface_.sum_up();
  level_.sum_up();
  find_supports();
}

Eigen::Vector3i BoxFeatures::box_cell_of(std::size_t voxel) const {
  const Eigen::Vector3i from_low = voxels_.cells[voxel] - low_;
  return {from_low.x() / kCellEdge, from_low.y() / kCellEdge,
          std::min(std::max(from_low.z(), 0), surface_.size().z() - 1)};
}

std::size_t BoxFeatures::place(const Eigen::Vector3i& cell) const {
  const auto at = [](int index) { return static_cast<std::size_t>(index); };
  const Eigen::Vector3i& size = surface_.size();
  return (at(cell.x()) * at(size.y()) + at(cell.y())) * at(size.z()) + at(cell.z());
}

/// Level cells of the window around a cell, in its layer and the one below.
int BoxFeatures::level_around(const Eigen::Vector3i& cell, int half_width) const {
  return level_.count({cell.x() - half_width, cell.y() - half_width, cell.z() - 1},
                      {cell.x() + half_width + 1, cell.y() + half_width + 1, cell.z() + 1});
}

/// What lies higher than a layer rests on it where a good part of the window around is level.
void BoxFeatures::find_supports() {
  const Eigen::Vector3i& size = surface_.size();
  supports_.assign(place(size - Eigen::Vector3i::Ones()) + 1, -1);
  for (int x = 0; x < size.x(); ++x) {
    for (int y = 0; y < size.y(); ++y) {
      std::int16_t below = -1;
      for (int z = 0; z < size.z(); ++z) {
        const Eigen::Vector3i cell(x, y, z);
        supports_[place(cell)] = below;
        if (part(level_around(cell, kSupportHalfWidth), kSupportHalfWidth) > kSupportPart) {
          below = static_cast<std::int16_t>(z);
        }
      }
    }
  }
}

float* BoxFeatures::put_support(const Eigen::Vector3i& cell, float z_m, float* out) const {
  const int layer = supports_[place(cell)];
  const auto edge = static_cast<float>(voxels_.edge_m);
  const float support_z_m = layer < 0 ? 0.0F : static_cast<float>(layer + low_.z()) * edge;
  const Eigen::Vector3i below(cell.x(), cell.y(), std::max(layer, 0));
  *out++ = z_m - support_z_m;
  *out++ = support_z_m;
  *out++ = part(level_around(below, kWideHalfWidth), kWideHalfWidth);
  *out++ = part(level_around(cell, kSupportHalfWidth), kSupportHalfWidth);
  *out++ = part(level_around(cell, kWideHalfWidth), kWideHalfWidth);
  return out;
}

float* BoxFeatures::put(std::size_t voxel, float* out) const {
  const Eigen::Vector3i middle = box_cell_of(voxel);
  const auto put_box = [&](int half_width, int from, int to) {
    const Eigen::Vector3i low(middle.x() - half_width, middle.y() - half_width, from);
    const Eigen::Vector3i high(middle.x() + half_width + 1, middle.y() + half_width + 1, to);
    *out++ = part(surface_.count(low, high), half_width);
    *out++ = part(level_.count(low, high), half_width);
  };
  for (const int half_width : kNearHalfWidths) {
    for (std::size_t e = 0; e + 1 < kNearEdges_m.size(); ++e) {
      put_box(half_width, middle.z() + layer_of(kNearEdges_m[e], voxels_.edge_m),
              middle.z() + layer_of(kNearEdges_m[e + 1], voxels_.edge_m));
    }
  }
  for (const int half_width : kStandingHalfWidths) {
    for (std::size_t e = 0; e + 1 < kStandingEdges_m.size(); ++e) {
      put_box(half_width, layer_of(kStandingEdges_m[e], voxels_.edge_m) - low_.z(),
              layer_of(kStandingEdges_m[e + 1], voxels_.edge_m) - low_.z());
    }
  }
  return put_support(middle, voxels_.positions[voxel].z(), out);
}

}  // namespace amiss::semantics
