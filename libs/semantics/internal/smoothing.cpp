#include "semantics/internal/smoothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "semantics/parallel.hpp"

namespace amiss::semantics {

namespace {

struct Neighbour {
  std::uint32_t voxel = 0;
  float weight = 0;  // those of a voxel add up to one
};
struct Neighbours {
  std::array<Neighbour, 26> list;
  std::uint8_t count = 0;
};

float likeness(const Voxels& voxels, std::size_t a, std::size_t b, float colour_scale) {
  const float colour = (voxels.colours[a] - voxels.colours[b]).squaredNorm() / (colour_scale * colour_scale);
  const float turn = std::max(voxels.normals[a].dot(voxels.normals[b]), 0.0F);
  return std::exp(-0.5F * colour) * (0.05F + turn * turn);
}

Neighbours neighbours_of(const Voxels& voxels, std::size_t v, float colour_scale) {
  Neighbours found;
  float sum = 0;
  for_neighbours([&](const Eigen::Vector3i& offset) {
    if (offset.isZero()) return;
    const std::uint32_t other = voxels.at(voxels.cells[v] + offset);
    if (other == Voxels::kNone) return;
    const float weight = likeness(voxels, v, other, colour_scale);
    found.list[found.count++] = {other, weight};
    sum += weight;
  });
  if (sum <= 1e-6F) found.count = 0;
  for (std::size_t n = 0; n < found.count; ++n) found.list[n].weight /= sum;
  return found;
}

}  // namespace

std::vector<float> smoothed(const Voxels& voxels, const std::vector<float>& probabilities,
                            const SmoothingParams& params, int threads) {
  if (voxels.size() == 0) return {};
  const std::size_t classes = probabilities.size() / voxels.size();
  std::vector<Neighbours> neighbours(voxels.size());
  in_parallel(voxels.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      neighbours[v] = neighbours_of(voxels, v, static_cast<float>(params.colour_scale));
    }
  });
  const auto strength = static_cast<float>(params.strength);
  std::vector<float> now = probabilities, next(now.size());
  for (int round = 0; round < params.rounds; ++round) {
    in_parallel(voxels.size(), threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        const float own = neighbours[v].count == 0 ? 1.0F : 1.0F - strength;
        float* const out = next.data() + v * classes;
        for (std::size_t c = 0; c < classes; ++c) out[c] = own * probabilities[v * classes + c];
        for (std::size_t n = 0; n < neighbours[v].count; ++n) {
          const Neighbour& other = neighbours[v].list[n];
          const float* const from = now.data() + other.voxel * classes;
          for (std::size_t c = 0; c < classes; ++c) out[c] += strength * other.weight * from[c];
        }
      }
    });
    std::swap(now, next);
  }
  return now;
}

}  // namespace amiss::semantics
