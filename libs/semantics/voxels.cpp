#include "semantics/voxels.hpp"

#include <array>
#include <cmath>

#include "semantics/internal/cloud_check.hpp"

namespace amiss::semantics {

namespace {

std::array<float, 256> linear_table() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double c = static_cast<double>(i) / 255.0;
    table[i] = static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return table;
}

float lab_curve(float t) { return t > 0.008856F ? std::cbrt(t) : 7.787F * t + 16.0F / 116.0F; }

}  // namespace

Eigen::Vector3f lab_of(const Rgb& colour) {
  static const std::array<float, 256> kLinear = linear_table();
  const Eigen::Vector3f rgb(kLinear[colour.r], kLinear[colour.g], kLinear[colour.b]);
  const float x = lab_curve(rgb.dot(Eigen::Vector3f(0.4124F, 0.3576F, 0.1805F)) / 0.9505F);
  const float y = lab_curve(rgb.dot(Eigen::Vector3f(0.2126F, 0.7152F, 0.0722F)));
  const float z = lab_curve(rgb.dot(Eigen::Vector3f(0.0193F, 0.1192F, 0.9505F)) / 1.0890F);
  return {1.16F * y - 0.16F, 5.0F * (x - y), 2.0F * (y - z)};
}

Voxels voxels_of(const Cloud<Map>& cloud, double edge_m) {
  check_cloud(cloud);
  Voxels voxels;
  voxels.edge_m = edge_m;
  voxels.of_point.assign(cloud.points.size(), Voxels::kNone);
  std::vector<std::uint32_t> counts;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Eigen::Vector3f& p = cloud.points[i];
    if (!is_near(p)) continue;
    const Eigen::Vector3i cell = cell_of(p, edge_m);
    const std::uint32_t v = voxels.index.at_or_put(cell_key(cell), static_cast<std::uint32_t>(voxels.size()));
    if (v == voxels.size()) {
      voxels.cells.push_back(cell);
      for (auto* sums : {&voxels.positions, &voxels.colours, &voxels.normals}) sums->push_back(Eigen::Vector3f::Zero());
      counts.push_back(0);
    }
    voxels.of_point[i] = v;
    ++counts[v];
    voxels.positions[v] += p;
    if (!cloud.colours.empty()) voxels.colours[v] += lab_of(cloud.colours[i]);
    if (!cloud.normals.empty() && cloud.normals[i].allFinite()) voxels.normals[v] += cloud.normals[i];
  }
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    voxels.positions[v] /= static_cast<float>(counts[v]);
    voxels.colours[v] /= static_cast<float>(counts[v]);
    const float length = voxels.normals[v].norm();
    voxels.normals[v] = length > 1e-3F ? Eigen::Vector3f(voxels.normals[v] / length) : Eigen::Vector3f::Zero();
  }
  return voxels;
}

}  // namespace amiss::semantics
