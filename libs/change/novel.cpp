#include "change/novel.hpp"

#include <algorithm>
#include <cmath>

#include "change/internal/baselines.hpp"
#include "change/internal/candidates.hpp"
#include "change/internal/recoloured.hpp"
#include "core/result.hpp"

namespace amiss::change {

namespace {

using internal::Candidate;
using internal::From;
using internal::RoomPair;
using internal::Surfaces;
using segment::Indices;

struct Found {
  Indices novel;  // of the thinned current scene
  std::vector<Decision> decisions;
};

std::vector<Candidate> candidates_of(const RoomPair& pair, From from, Surfaces surfaces, const NovelParams& params) {
  return internal::candidates_of(pair.current, pair.supports, from, surfaces, params);
}

/// Clusters of what has another colour than the surface it lies on; what is novel already joins them.
void add_flat(Found& found, const RoomPair& pair, const NovelParams& params) {
  for (Indices& cluster : segment::euclidean_clusters(pair.current.points, internal::recoloured(pair, params),
                                                      static_cast<float>(params.cluster_distance_m),
                                                      static_cast<std::size_t>(params.min_points))) {
    Decision decision = internal::described(pair.current, {cluster, "colour", 0.0});
    const bool large = (decision.high_m - decision.low_m).maxCoeff() > params.max_size_m;
    decision.verdict = large ? Verdict::kTooLarge : Verdict::kNovel;
    if (!large) found.novel.insert(found.novel.end(), cluster.begin(), cluster.end());
    found.decisions.push_back(std::move(decision));
  }
}

Found locally_verified(const RoomPair& pair, From from, const NovelParams& params) {
  Found found;
  std::vector<internal::Motion> motions;
  for (const Candidate& candidate : candidates_of(pair, from, Surfaces::kLeftOut, params)) {
    internal::Verified v = internal::verified(pair, candidate, motions, params);
    std::move(v.motions.begin(), v.motions.end(), std::back_inserter(motions));
    found.novel.insert(found.novel.end(), v.novel.begin(), v.novel.end());
    std::move(v.decisions.begin(), v.decisions.end(), std::back_inserter(found.decisions));
  }
  if (from == From::kPlanesAndLabels) add_flat(found, pair, params);
  return found;
}

/// Every candidate counts; of those that were cut out by planes only what has the size of an object: walls stand on
/// the floor too.
Found not_verified(const RoomPair& pair, From from, const NovelParams& params) {
  Found found;
  for (const Candidate& candidate : candidates_of(pair, from, Surfaces::kKept, params)) {
    Decision decision = internal::described(pair.current, candidate);
    const bool large = candidate.source == "plane" && (decision.high_m - decision.low_m).maxCoeff() > params.max_size_m;
    decision.verdict = large ? Verdict::kTooLarge : Verdict::kNotVerified;
    if (!large) found.novel.insert(found.novel.end(), candidate.points.begin(), candidate.points.end());
    found.decisions.push_back(std::move(decision));
  }
  return found;
}

/// The points of the scene whose thinned points are novel, in clusters (Section 5.2.2, last step); decisions are told
/// what became of them.
std::vector<NovelObject> objects_of(const Scene& scene, const internal::ThinnedScene& thinned, Found& found,
                                    const NovelParams& params) {
  Indices& novel = found.novel;
  std::sort(novel.begin(), novel.end());
  novel.erase(std::unique(novel.begin(), novel.end()), novel.end());
  std::vector<NovelObject> objects;
  std::vector<int> object_of(thinned.points.size(), -1);
  for (const Indices& cluster :
       segment::euclidean_clusters(thinned.points, novel, static_cast<float>(params.filter_distance_m),
                                   static_cast<std::size_t>(params.min_points))) {
    for (const std::uint32_t i : cluster) object_of[i] = static_cast<int>(objects.size());
    objects.emplace_back();
  }
  for (std::uint32_t i = 0; i < thinned.thinned_of.size(); ++i) {
    const int k = object_of[thinned.thinned_of[i]];
    if (k < 0) continue;
    NovelObject& object = objects[static_cast<std::size_t>(k)];
    const Eigen::Vector3d p = scene.cloud.points[i].cast<double>();
    if (object.points.empty()) object.low_m = object.high_m = p;
    object.low_m = object.low_m.cwiseMin(p);
    object.high_m = object.high_m.cwiseMax(p);
    object.points.push_back(i);
  }
  for (Decision& d : found.decisions) {
    const bool counts = d.verdict == Verdict::kNovel || d.verdict == Verdict::kNotVerified;
    if (counts && object_of[d.point] >= 0) d.object = static_cast<std::size_t>(object_of[d.point]);
  }
  return objects;
}

void check_method(const std::string& method) {
  const auto& methods = detection_methods();
  if (std::find(methods.begin(), methods.end(), method) != methods.end()) return;
  std::string all;
  for (const std::string& m : methods) all += (all.empty() ? "" : ", ") + m;
  throw ArgumentError("'" + method + "' is no method of detection; allowed are " + all + ".");
}

}  // namespace

const std::vector<std::string>& detection_methods() {
  static const std::vector<std::string> kMethods = {"local-verification", "no-planes", "no-verification",
                                                    "semantic",           "octomap",   "metaroom"};
  return kMethods;
}

struct NovelDetector::Rooms {
  const Scene& reference;
  const Scene& current;
  NovelParams params;
  RoomPair pair;
};

NovelDetector::NovelDetector(const Scene& reference, const Scene& current, const NovelParams& params)
    : rooms_(new Rooms{reference, current, params, internal::room_pair(reference, current, params)}) {}

NovelDetector::~NovelDetector() = default;

Detection NovelDetector::detect(const std::string& method) const {
  check_method(method);
  const auto& [reference, current, params, pair] = *rooms_;
  Found found;
  if (method == "local-verification") found = locally_verified(pair, From::kPlanesAndLabels, params);
  if (method == "no-planes") found = locally_verified(pair, From::kLabels, params);
  if (method == "no-verification") found = not_verified(pair, From::kPlanesAndLabels, params);
  if (method == "semantic") found = not_verified(pair, From::kLabels, params);
  if (method == "octomap") found.novel = internal::octomap_difference(reference, pair.current);
  if (method == "metaroom") found.novel = internal::metaroom_difference(pair, params);

  Detection out;
  out.objects = objects_of(current, pair.current, found, params);
  out.decisions = std::move(found.decisions);
  out.planes = static_cast<int>(pair.supports.size());
  const Eigen::Isometry3f& T = pair.drift.whole();
  out.shift_m = T.translation().cast<double>();
  out.turn_rad = static_cast<double>(std::atan2(T.linear()(1, 0), T.linear()(0, 0)));
  return out;
}

Detection detect_novel(const Scene& reference, const Scene& current, const std::string& method,
                       const NovelParams& params) {
  check_method(method);
  return NovelDetector(reference, current, params).detect(method);
}

}  // namespace amiss::change
