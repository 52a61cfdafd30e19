#include "semantics/forest_labeller.hpp"

#include <algorithm>
#include <cmath>

#include "core/result.hpp"
#include "semantics/internal/smoothing.hpp"
#include "semantics/parallel.hpp"
#include "semantics/voxel_features.hpp"

namespace amiss::semantics {

namespace {

/// The class that is most probable at a point, by the eight voxels whose middles are around it.
std::size_t most_probable(const Voxels& voxels, const std::vector<float>& probabilities, const Eigen::Vector3f& p,
                          std::span<float> sums) {
  std::fill(sums.begin(), sums.end(), 0.0F);
  const auto half = static_cast<float>(voxels.edge_m / 2);
  const Eigen::Vector3i low = cell_of(p - Eigen::Vector3f::Constant(half), voxels.edge_m);
  for (int corner = 0; corner < 8; ++corner) {
    const std::uint32_t v = voxels.at(low + Eigen::Vector3i(corner & 1, (corner >> 1) & 1, corner >> 2));
    if (v == Voxels::kNone) continue;
    const float weight = std::exp(-0.5F * (voxels.positions[v] - p).squaredNorm() / (half * half));
    for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += weight * probabilities[v * sums.size() + c];
  }
  return static_cast<std::size_t>(std::max_element(sums.begin(), sums.end()) - sums.begin());
}

}  // namespace

void describe(ParamTable& table, ForestLabellerParams& p) {
  table.integer("semantics.forest.rounds", p.smoothing_rounds, 0, 50, "rounds of smoothing over neighbours");
  table.number("semantics.forest.smoothing", p.smoothing, "", 0.0, 1.0, "of neighbours against the voxel itself");
  table.number("semantics.forest.colour_scale", p.colour_scale, "", 0.01, 1.0,
               "difference of colour (CIE Lab / 100) across which neighbours count less");
  table.integer("semantics.forest.threads", p.threads, 1, 64, "threads that label; the labels are the same");
}

ForestLabeller::ForestLabeller(Forest forest, std::string source, const ForestLabellerParams& params)
    : forest_(std::move(forest)), source_(std::move(source)), params_(params) {}

LabellerIdentity ForestLabeller::identity() const { return {"forest", source_, true}; }

std::vector<SemanticClass> ForestLabeller::label(const Cloud<Map>& cloud) const {
  const VoxelFeatures features = voxel_features(cloud, forest_.voxel_m, params_.threads);
  const Voxels& voxels = features.voxels;
  const std::size_t classes = forest_.classes.size();
  std::vector<float> probabilities(voxels.size() * classes);
  in_parallel(voxels.size(), params_.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      forest_.classify(features.of(v), std::span(probabilities).subspan(v * classes, classes));
    }
  });
  const SmoothingParams smoothing{params_.smoothing_rounds, params_.smoothing, params_.colour_scale};
  probabilities = smoothed(voxels, probabilities, smoothing, params_.threads);
  std::vector<SemanticClass> labels(cloud.points.size(), SemanticClass::kUnlabelled);
  in_parallel(labels.size(), params_.threads, [&](std::size_t begin, std::size_t end) {
    std::vector<float> sums(classes);
    for (std::size_t i = begin; i < end; ++i) {
      if (voxels.of_point[i] == Voxels::kNone) continue;
      labels[i] = forest_.classes[most_probable(voxels, probabilities, cloud.points[i], sums)];
    }
  });
  return labels;
}

ForestLabeller load_forest_labeller(const std::filesystem::path& file, const ForestLabellerParams& params) {
  return {load_forest(file), file.filename().string(), params};
}

}  // namespace amiss::semantics
