// Local verification (Section 5.2.2) of one candidate cluster: at rest, moved a little as a whole, or novel; and where
// a part of it is neither, that part alone, so that a new object does not vanish with the permanent one it touches.
// in: two rooms laid on one another, a cluster of current points. out: decisions, and the points that are novel.
//
// A fit of a cluster to the reference says "moved a little" only when its counterpart there is not still in its old
// place, and when all of the counterpart that has gone finds itself in the current room: small things fit anywhere.
#pragma once

#include <string>

#include "change/internal/room_pair.hpp"

namespace amiss::change::internal {

/// Points of the current scene that may be an object, and how they were found.
struct Candidate {
  segment::Indices points;  // ascending
  std::string source;
  double support_height_m = 0.0;
};

/// A thing that moved a little, and the crop round it (c_curr) that moved with it.
struct Motion {
  Eigen::Isometry3f T = Eigen::Isometry3f::Identity();
  Eigen::Array3f low = Eigen::Array3f::Zero(), high = Eigen::Array3f::Zero();  // where it lies on the reference
};

struct Verified {
  std::vector<Decision> decisions;
  segment::Indices novel;
  std::vector<Motion> motions;
};

/// `known`: motions of candidates that were verified before.
[[nodiscard]] Verified verified(const RoomPair& pair, const Candidate& candidate, const std::vector<Motion>& known,
                                const NovelParams& params);

/// What is known of a candidate before it is verified: source, points, class, bounds.
[[nodiscard]] Decision described(const ThinnedScene& current, const Candidate& candidate);

}  // namespace amiss::change::internal
