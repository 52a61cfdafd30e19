// Labels a reconstruction with a forest that was trained on rooms generated for it (in place of SparseConvNet of the
// thesis, 5.3.2.2): features of voxels, a forest's probabilities, smoothed over neighbours; a point takes the class
// that the voxels nearest to it make most probable. It knows the cloud and nothing else.
#pragma once

#include <filesystem>

#include "core/params.hpp"
#include "semantics/forest.hpp"
#include "semantics/semantic_labeller.hpp"

namespace amiss::semantics {

struct ForestLabellerParams {
  int smoothing_rounds = 4;
  double smoothing = 0.7;  // of neighbours against what a voxel itself says
  double colour_scale = 0.08;
  int threads = 2;  // the labels are the same for any number
};
void describe(ParamTable& table, ForestLabellerParams& params);

class ForestLabeller final : public SemanticLabeller {
 public:
  /// `source`: what reports call it.
  ForestLabeller(Forest forest, std::string source, const ForestLabellerParams& params = {});

  [[nodiscard]] LabellerIdentity identity() const override;
  [[nodiscard]] std::vector<SemanticClass> label(const Cloud<Map>& cloud) const override;

 private:
  Forest forest_;
  std::string source_;
  ForestLabellerParams params_;
};

/// InputError that names the file where it is no forest.
[[nodiscard]] ForestLabeller load_forest_labeller(const std::filesystem::path& file,
                                                  const ForestLabellerParams& params = {});

}  // namespace amiss::semantics
