// The simulator's own classes, spoiled: for ablations only, marked as not learned.
// in: points with their true classes (map frame [m]); how much to spoil     out: a labeller of other clouds of the
// same place: a point takes the class of the true point nearest to it (within reach_m; kUnlabelled beyond), then
//   boundary blur: it looks at a place beside it instead, displaced by a normal distribution of blur_m along each axis,
//   the same for all points of a cell of 2 cm; so borders between classes fray and thin things drown;
//   confusion: whole patches of patch_m change their class by the rows of a confusion matrix, taken in so far as
//   confusion_strength says (0 leaves all, 1 takes the rows as they are).
// Errors: ArgumentError for numbers out of range and clouds that are not as long as their classes.
#pragma once

#include <cstdint>

#include "core/params.hpp"
#include "semantics/confusion.hpp"
#include "semantics/semantic_labeller.hpp"

namespace amiss::semantics {

struct SpoilParams {
  double blur_m = 0.0;
  double confusion_strength = 0.0;
  double patch_m = 0.15;
  double reach_m = 0.05;
};
void describe(ParamTable& table, SpoilParams& params);

class RenderedLabeller final : public SemanticLabeller {
 public:
  struct Truth {
    std::vector<Eigen::Vector3f> points;
    std::vector<SemanticClass> classes;
  };
  RenderedLabeller(Truth truth, const Confusion& confusion, const SpoilParams& params, std::uint64_t seed);

  [[nodiscard]] LabellerIdentity identity() const override;
  [[nodiscard]] std::vector<SemanticClass> label(const Cloud<Map>& cloud) const override;

 private:
  [[nodiscard]] SemanticClass true_class(const Eigen::Vector3f& p) const;
  [[nodiscard]] Eigen::Vector3f displaced(const Eigen::Vector3f& p) const;
  [[nodiscard]] SemanticClass confused(SemanticClass value, const Eigen::Vector3f& p) const;

  struct Entry {
    std::uint64_t cell;
    std::uint32_t point;
  };
  Truth truth_;
  std::vector<Entry> entries_;  // sorted
  Confusion confusion_;
  SpoilParams params_;
  std::uint64_t seed_;
};

}  // namespace amiss::semantics
