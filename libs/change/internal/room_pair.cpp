#include "change/internal/room_pair.hpp"

#include <algorithm>
#include <cmath>
#include <future>

namespace amiss::change::internal {

namespace {

constexpr int kNudgeCells = 5;  // furniture is nudged by so much: 10 cm
constexpr double kMinShare = 0.3;
constexpr double kSameSurfaceM = 0.012;  // parts of one surface differ by no more in their offset from the reference
constexpr int kRimCells = 2;
constexpr double kTopOfThingM2 = 0.05;  // a smaller surface stays with the thing whose top it is

struct Partner {
  std::size_t current = 0, reference = 0;
  double shared_m2 = 0.0, rise_m = 0.0;  // of the current plane above the reference's
};

/// Height of the plane where the other one's middle is.
double height_under(const segment::SupportPlane& plane, const Eigen::Vector3f& middle) {
  const Eigen::Vector3d& n = plane.plane.normal_map;
  return -(n.x() * static_cast<double>(middle.x()) + n.y() * static_cast<double>(middle.y()) + plane.plane.d_m) / n.z();
}

Eigen::Vector3f middle_of(const ThinnedScene& scene, const segment::SupportPlane& plane) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::uint32_t i : plane.inliers) sum += scene.points[i].cast<double>();
  return (sum / static_cast<double>(plane.inliers.size())).cast<float>();
}

std::vector<Partner> partners_of(const ThinnedScene& reference, const ThinnedScene& current, const Drift& drift,
                                 double max_rise_m) {
  std::vector<Partner> partners;
  for (std::size_t r = 0; r < reference.planes.size(); ++r) {
    const segment::Footprint wide = reference.planes[r].footprint.filled().dilated(kNudgeCells);
    for (std::size_t c = 0; c < current.planes.size(); ++c) {
      const Eigen::Vector3f middle = drift.whole() * middle_of(current, current.planes[c]);
      const double rise = static_cast<double>(middle.z()) - height_under(reference.planes[r], middle);
      if (std::abs(rise) > max_rise_m) continue;
      const double shared = current.planes[c].footprint.shared_area_m2(wide);
      if (shared < kMinShare * current.planes[c].area_m2) continue;
      partners.push_back({c, r, shared, rise});
    }
  }
  return partners;
}

/// Planes of the current scene that are surfaces: the best partner of some plane of the reference, or as high as it.
/// What lies flat on a surface is no surface.
std::vector<Partner> surfaces_among(const std::vector<Partner>& partners, std::size_t references) {
  std::vector<const Partner*> best(references, nullptr);
  for (const Partner& p : partners) {
    if (best[p.reference] == nullptr || p.shared_m2 > best[p.reference]->shared_m2) best[p.reference] = &p;
  }
  std::vector<Partner> surfaces;
  for (const Partner& p : partners) {
    if (std::abs(p.rise_m - best[p.reference]->rise_m) <= kSameSurfaceM) surfaces.push_back(p);
  }
  return surfaces;
}

void keep_surfaces(RoomPair& pair, const NovelParams& params) {
  const auto keep = [](std::vector<segment::SupportPlane>& to, const segment::SupportPlane& plane) {
    if (plane.area_m2 >= kTopOfThingM2) to.push_back(plane);
  };
  const auto surfaces = surfaces_among(partners_of(pair.reference, pair.current, pair.drift, params.plane_alignment_m),
                                       pair.reference.planes.size());
  std::vector<segment::SupportPlane> of_reference;
  for (std::size_t c = 0; c < pair.current.planes.size(); ++c) {
    segment::Footprint ground;
    bool surface = false;
    for (const Partner& p : surfaces) {
      if (p.current != c) continue;
      surface = true;
      ground = ground.united(pair.reference.planes[p.reference].footprint);
    }
    if (!surface) continue;
    const segment::SupportPlane& plane = pair.current.planes[c];
    pair.supports.push_back({plane, ground.united(plane.footprint).filled().dilated(kRimCells)});
  }
  for (std::size_t r = 0; r < pair.reference.planes.size(); ++r) {
    const auto uses = [r](const Partner& p) { return p.reference == r; };
    if (std::any_of(surfaces.begin(), surfaces.end(), uses)) keep(of_reference, pair.reference.planes[r]);
  }
  std::vector<segment::SupportPlane> of_current;
  for (const Support& support : pair.supports) keep(of_current, support.plane);
  pair.reference.on_plane = marked(pair.reference.points.size(), of_reference);
  pair.current.on_plane = marked(pair.current.points.size(), of_current);
}

}  // namespace

bool explains(const ThinnedScene& reference, const Eigen::Vector3f& p, const NovelParams& params) {
  const auto level = static_cast<float>(params.planes.distance_m);
  bool found = false;
  reference.grid.for_each_within(p, static_cast<float>(params.difference_m), [&](std::uint32_t j, float) {
    found = found || !reference.on_plane[j] || std::abs(p.z() - reference.points[j].z()) <= level;
  });
  return found;
}

RoomPair room_pair(const Scene& reference, const Scene& current, const NovelParams& params) {
  auto in_parallel = std::async(std::launch::async, [&] { return thinned(reference, params); });
  ThinnedScene now = thinned(current, params);
  ThinnedScene before = in_parallel.get();
  Drift drift(before, now, 2.0 * params.plane_alignment_m);
  RoomPair pair{std::move(before), std::move(now), {}, std::move(drift), {}, {{}, 1.0F}, {}, {}, nullptr, nullptr};
  if (reference.space) pair.reference_space = &*reference.space;
  if (current.space) pair.current_space = &*current.space;
  keep_surfaces(pair, params);
  std::vector<Eigen::Vector3f> stuff;
  for (std::uint32_t j = 0; j < pair.reference.points.size(); ++j) {
    if (pair.reference.on_plane[j]) continue;
    pair.stuff.push_back(j);
    stuff.push_back(pair.reference.points[j]);
  }
  pair.stuff_grid = segment::PointGrid(std::move(stuff), kGridEdgeM);
  pair.placed.reserve(pair.current.points.size());
  for (std::uint32_t i = 0; i < pair.current.points.size(); ++i) {
    const Eigen::Vector3f& p = pair.current.points[i];
    pair.placed.emplace_back(pair.drift.at(p) * p);
    pair.explained.push_back(pair.current.on_plane[i] || explains(pair.reference, pair.placed[i], params));
  }
  return pair;
}

}  // namespace amiss::change::internal
