#include "semantics/rendered_labeller.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "core/random.hpp"
#include "core/result.hpp"
#include "semantics/internal/cells.hpp"
#include "semantics/internal/cloud_check.hpp"

namespace amiss::semantics {

namespace {

constexpr double kBlurCell_m = 0.02;

void check(const SpoilParams& p) {
  if (!(p.blur_m >= 0) || !(p.confusion_strength >= 0 && p.confusion_strength <= 1) || !(p.patch_m >= 0.01) ||
      !(p.reach_m >= 0.005)) {
    throw ArgumentError(
        "spoiled classes: a blur from 0 m, a strength of confusion in 0 .. 1, patches from 0.01 m and a reach from "
        "0.005 m are allowed");
  }
}

}  // namespace

void describe(ParamTable& table, SpoilParams& p) {
  table.number("semantics.rendered.blur", p.blur_m, "m", 0.0, 0.2, "how far classes fray at their borders");
  table.number("semantics.rendered.confusion", p.confusion_strength, "", 0.0, 1.0,
               "share of the confusion matrix that is taken in");
  table.number("semantics.rendered.patch", p.patch_m, "m", 0.01, 2.0, "edge of what is confused as one");
  table.number("semantics.rendered.reach", p.reach_m, "m", 0.005, 0.5, "how far away the true point may be");
}

RenderedLabeller::RenderedLabeller(Truth truth, const Confusion& confusion, const SpoilParams& params,
                                   std::uint64_t seed)
    : truth_(std::move(truth)), confusion_(confusion), params_(params), seed_(seed) {
  check(params);
  if (truth_.points.size() != truth_.classes.size()) {
    throw ArgumentError("true classes: " + std::to_string(truth_.classes.size()) + " for " +
                        std::to_string(truth_.points.size()) + " points; as many are needed");
  }
  for (std::size_t i = 0; i < truth_.points.size(); ++i) {
    if (!is_near(truth_.points[i])) continue;
    entries_.push_back({cell_key(cell_of(truth_.points[i], params_.reach_m)), static_cast<std::uint32_t>(i)});
  }
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return a.cell != b.cell ? a.cell < b.cell : a.point < b.point; });
}

LabellerIdentity RenderedLabeller::identity() const {
  return {"rendered", "the simulator's own classes, spoiled", false};
}

std::vector<SemanticClass> RenderedLabeller::label(const Cloud<Map>& cloud) const {
  check_cloud(cloud);
  std::vector<SemanticClass> classes;
  classes.reserve(cloud.points.size());
  for (const Eigen::Vector3f& p : cloud.points) {
    if (!is_near(p)) {
      classes.push_back(SemanticClass::kUnlabelled);
      continue;
    }
    SemanticClass value = true_class(p);
    if (params_.blur_m > 0 && value != SemanticClass::kUnlabelled) {
      const SemanticClass beside = true_class(displaced(p));
      if (beside != SemanticClass::kUnlabelled) value = beside;
    }
    classes.push_back(confused(value, p));
  }
  return classes;
}

SemanticClass RenderedLabeller::true_class(const Eigen::Vector3f& p) const {
  const Eigen::Vector3i cell = cell_of(p, params_.reach_m);
  const auto reach = static_cast<float>(params_.reach_m);
  float nearest = reach * reach;
  std::uint32_t best = std::numeric_limits<std::uint32_t>::max();
  for_neighbours([&](const Eigen::Vector3i& offset) {
    const std::uint64_t key = cell_key(cell + offset);
    auto entry = std::lower_bound(entries_.begin(), entries_.end(), key,
                                  [](const Entry& e, std::uint64_t wanted) { return e.cell < wanted; });
    for (; entry != entries_.end() && entry->cell == key; ++entry) {
      const float distance = (truth_.points[entry->point] - p).squaredNorm();
      if (distance > nearest || (distance == nearest && entry->point > best)) continue;
      nearest = distance;
      best = entry->point;
    }
  });
  return best < truth_.classes.size() ? truth_.classes[best] : SemanticClass::kUnlabelled;
}

Eigen::Vector3f RenderedLabeller::displaced(const Eigen::Vector3f& p) const {
  RandomStream random(seed_ ^ mixed(cell_key(cell_of(p, kBlurCell_m))), "semantics/blur");
  Eigen::Vector3f moved = p;
  for (int axis = 0; axis < 3; ++axis) moved[axis] += static_cast<float>(random.normal() * params_.blur_m);
  return moved;
}

SemanticClass RenderedLabeller::confused(SemanticClass value, const Eigen::Vector3f& p) const {
  const std::uint64_t total = confusion_.total_of(value);
  if (value == SemanticClass::kUnlabelled || params_.confusion_strength <= 0 || total == 0) return value;
  const std::uint64_t patch = mixed(cell_key(cell_of(p, params_.patch_m))) + static_cast<std::uint64_t>(value);
  RandomStream random(seed_ ^ patch, "semantics/confusion");
  if (random.uniform() >= params_.confusion_strength) return value;
  std::uint64_t drawn = random.below(total);
  for (const NamedSemanticClass& c : kSemanticClasses) {
    const std::uint64_t count = confusion_.count(value, c.value);
    if (drawn < count) return c.value;
    drawn -= count;
  }
  return value;
}

}  // namespace amiss::semantics
