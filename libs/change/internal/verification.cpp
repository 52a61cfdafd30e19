#include "change/internal/verification.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "change/internal/counterpart.hpp"
#include "change/internal/object_fit.hpp"
#include "change/internal/surroundings.hpp"

namespace amiss::change::internal {

namespace {

constexpr double kMaxFurnitureM = 1.6;    // what is wider is built in, and does not move
constexpr double kMinUnexplained = 0.05;  // of a cluster, before it is asked whether it moved as a whole
constexpr float kDepthReachM = 0.05F;     // what is farther from the reference is no deeper
constexpr std::size_t kMinRest = 60;      // points of a thing beside what is no object; less are its frayed edges

using segment::Indices;

std::vector<Eigen::Vector3f> at(const std::vector<Eigen::Vector3f>& points, const Indices& among) {
  std::vector<Eigen::Vector3f> some;
  some.reserve(among.size());
  for (const std::uint32_t i : among) some.push_back(points[i]);
  return some;
}

/// Stuff of the reference in the box of the points, wider by c_ref.
std::vector<Eigen::Vector3f> stuff_near(const RoomPair& pair, const std::vector<Eigen::Vector3f>& points,
                                        const NovelParams& params) {
  Eigen::Array3f low = points.front(), high = low;
  for (const Eigen::Vector3f& p : points) {
    low = low.min(p.array());
    high = high.max(p.array());
  }
  const auto margin = static_cast<float>(params.reference_margin_m);
  std::vector<Eigen::Vector3f> near;
  for (const std::uint32_t j : pair.stuff) {
    const Eigen::Vector3f& p = pair.reference.points[j];
    if ((p.array() >= low - margin).all() && (p.array() <= high + margin).all()) near.push_back(p);
  }
  return near;
}

/// Of the points, those that the reference does not hold after the motion either.
Indices left_by(const RoomPair& pair, const Indices& points, const Motion& motion, const NovelParams& params) {
  Indices left;
  for (const std::uint32_t i : points) {
    const Eigen::Vector3f& p = pair.placed[i];
    const bool inside = (p.array() >= motion.low).all() && (p.array() <= motion.high).all();
    if (!inside || !explains(pair.reference, motion.T * p, params)) left.push_back(i);
  }
  return left;
}

Motion motion_of(const RoomPair& pair, const Indices& points, const Fit& fit, const NovelParams& params) {
  Motion motion{fit.T, pair.placed[points.front()], pair.placed[points.front()]};
  for (const std::uint32_t i : points) {
    motion.low = motion.low.min(pair.placed[i].array());
    motion.high = motion.high.max(pair.placed[i].array());
  }
  motion.low -= static_cast<float>(params.current_margin_m);
  motion.high += static_cast<float>(params.current_margin_m);
  return motion;
}

bool unseen(const RoomPair& pair, std::uint32_t i) {
  return pair.reference_space != nullptr &&
         pair.reference_space->at(pair.placed[i].cast<double>()) == Occupancy::kUnknown;
}

double unseen_share(const RoomPair& pair, const Indices& points) {
  const auto n = std::count_if(points.begin(), points.end(), [&](std::uint32_t i) { return unseen(pair, i); });
  return static_cast<double>(n) / static_cast<double>(points.size());
}

/// Upper quartile of the distances from the reference.
double depth_of(const RoomPair& pair, const Indices& points) {
  std::vector<float> distances;
  distances.reserve(points.size());
  for (const std::uint32_t i : points) {
    const auto nearest = pair.reference.grid.nearest(pair.placed[i], kDepthReachM);
    distances.push_back(nearest ? std::sqrt(nearest->squared_m2) : kDepthReachM);
  }
  const auto quartile = distances.begin() + 3 * std::ssize(distances) / 4;
  std::nth_element(distances.begin(), quartile, distances.end());
  return static_cast<double>(*quartile);
}

double width_of(const Decision& d) { return (d.high_m - d.low_m).head<2>().maxCoeff(); }

/// Fits the points to the reference; true when they moved a little. The numbers go into the decision.
std::optional<Fit> moved_a_little(const RoomPair& pair, const Indices& points, Decision& decision,
                                  const NovelParams& params) {
  const std::vector<Eigen::Vector3f> placed = at(pair.placed, points);
  const Fit fit = best_fit(placed, stuff_near(pair, placed, params), params);
  decision.overlap_moved = fit.overlap;
  decision.moved_m = fit.moved_m;
  decision.turned_rad = fit.turned_rad;
  if (fit.overlap < params.max_overlap) return std::nullopt;
  const Counterpart counterpart = counterpart_of(pair, points, fit, params);
  decision.taken = counterpart.taken;
  decision.left_over = counterpart.left_over;
  decision.colour_distance = counterpart.colour_distance;
  const bool can_be = counterpart.taken <= params.max_taken && counterpart.left_over <= params.max_left_over &&
                      counterpart.colour_distance <= params.max_colour_distance;
  return can_be ? std::optional(fit) : std::nullopt;
}

/// The points of a part that are not what made it no object; none where the verdict does not rest on single points.
Indices rest_of(const RoomPair& pair, const Indices& points, Verdict verdict, const std::vector<Motion>& motions,
                const NovelParams& params) {
  if (verdict == Verdict::kMovedALittle) return left_by(pair, points, motions.back(), params);
  Indices rest;
  const auto leave_out = [&](const auto& rule) {
    std::copy_if(points.begin(), points.end(), std::back_inserter(rest), [&](std::uint32_t i) { return !rule(i); });
  };
  if (verdict == Verdict::kUnseen) leave_out([&](std::uint32_t i) { return unseen(pair, i); });
  if (verdict == Verdict::kContinued) leave_out([&](std::uint32_t i) { return continues(pair, i, params); });
  if (verdict == Verdict::kNudged) leave_out([&](std::uint32_t i) { return nudged(pair, i, params); });
  return rest;
}

/// A part that is not where it was.
Verdict decide_part(const RoomPair& pair, const Candidate& part, double overlap_at_rest, const NovelParams& params,
                    Verified& out) {
  Decision decision = described(pair.current, part);
  decision.overlap_at_rest = overlap_at_rest;
  decision.unseen = unseen_share(pair, part.points);
  decision.depth_m = depth_of(pair, part.points);
  decision.continued = continued_share(pair, part.points, params);
  decision.nudged = nudged_share(pair, part.points, params);
  if (decision.points < params.min_points) {
    decision.verdict = Verdict::kTooSmall;
  } else if (decision.unseen > params.max_unseen) {
    decision.verdict = Verdict::kUnseen;
  } else if (overlap_at_rest >= params.max_overlap && decision.depth_m < params.min_depth_m) {
    decision.verdict = Verdict::kShallow;
  } else if (decision.continued > params.max_continued) {
    decision.verdict = Verdict::kContinued;
  } else if (decision.nudged > params.max_nudged) {
    decision.verdict = Verdict::kNudged;
  } else if (width_of(decision) > params.max_size_m) {
    decision.verdict = Verdict::kTooLarge;
  } else if (const auto fit = moved_a_little(pair, part.points, decision, params)) {
    decision.verdict = Verdict::kMovedALittle;
    out.motions.push_back(motion_of(pair, part.points, *fit, params));
  } else {
    decision.verdict = Verdict::kNovel;
    out.novel.insert(out.novel.end(), part.points.begin(), part.points.end());
  }
  out.decisions.push_back(decision);
  return decision.verdict;
}

/// A part, and where most of it is no object by its surroundings, what is left of it: things lean on cushions.
void decide_part_and_rest(const RoomPair& pair, const Candidate& part, double overlap_at_rest,
                          const NovelParams& params, Verified& out) {
  const Verdict verdict = decide_part(pair, part, overlap_at_rest, params, out);
  for (Indices& rest :
       segment::euclidean_clusters(pair.current.points, rest_of(pair, part.points, verdict, out.motions, params),
                                   static_cast<float>(params.filter_distance_m), kMinRest)) {
    decide_part(pair, {std::move(rest), part.source, part.support_height_m}, overlap_at_rest, params, out);
  }
}

}  // namespace

Decision described(const ThinnedScene& current, const Candidate& candidate) {
  Decision d;
  d.source = candidate.source;
  d.support_height_m = candidate.support_height_m;
  d.points = static_cast<int>(candidate.points.size());
  d.point = candidate.points.front();
  d.low_m = d.high_m = current.points[candidate.points.front()].cast<double>();
  std::array<int, 256> votes{};
  for (const std::uint32_t i : candidate.points) {
    d.low_m = d.low_m.cwiseMin(current.points[i].cast<double>());
    d.high_m = d.high_m.cwiseMax(current.points[i].cast<double>());
    if (!current.labels.empty()) ++votes[static_cast<std::size_t>(current.labels[i])];
  }
  d.label = static_cast<SemanticClass>(std::max_element(votes.begin(), votes.end()) - votes.begin());
  return d;
}

Verified verified(const RoomPair& pair, const Candidate& candidate, const std::vector<Motion>& known,
                  const NovelParams& params) {
  Verified out;
  Decision whole = described(pair.current, candidate);
  Indices left;
  for (const std::uint32_t i : candidate.points) {
    if (!pair.explained[i]) left.push_back(i);
  }
  for (const Motion& motion : known) left = left_by(pair, left, motion, params);
  const double unexplained = static_cast<double>(left.size()) / static_cast<double>(candidate.points.size());
  whole.overlap_at_rest = 1.0 - unexplained;
  whole.verdict = Verdict::kAtRest;
  const auto parts = [&] {
    return segment::euclidean_clusters(pair.current.points, left, static_cast<float>(params.filter_distance_m),
                                       static_cast<std::size_t>(params.min_points));
  };
  std::vector<Indices> rest = parts();
  const bool may_move = unexplained >= kMinUnexplained && width_of(whole) <= kMaxFurnitureM;
  if (!rest.empty() && rest.front().size() < candidate.points.size() && may_move) {
    if (const auto fit = moved_a_little(pair, candidate.points, whole, params)) {
      whole.verdict = Verdict::kMovedALittle;
      out.motions.push_back(motion_of(pair, candidate.points, *fit, params));
      left = left_by(pair, left, out.motions.back(), params);
      rest = parts();
    }
  }
  // Small things lose their lowest points to what they lie on: then the whole counts, if it is enough.
  if (rest.empty() && whole.verdict == Verdict::kAtRest && whole.overlap_at_rest < params.max_overlap) {
    rest.push_back(candidate.points);
  }
  for (Indices& part : rest) {
    decide_part_and_rest(pair, {std::move(part), candidate.source, candidate.support_height_m}, whole.overlap_at_rest,
                         params, out);
  }
  if (rest.empty() || whole.verdict == Verdict::kMovedALittle) out.decisions.insert(out.decisions.begin(), whole);
  return out;
}

}  // namespace amiss::change::internal
