#include "dataset/internal/frame_tree.hpp"

#include "dataset/internal/folder_index.hpp"

namespace amiss::dataset {
namespace {

constexpr double kMaxGapS = 0.5;
constexpr int kMostLinks = 100;  // more are a circle

}  // namespace

void FrameTree::add(const RosTransform& transform, bool fixed) {
  Link& link = links_[transform.child];
  if (link.parent != transform.parent) link = {transform.parent, fixed, {}};  // it hangs elsewhere now
  link.fixed = fixed;
  link.T_parent_child[transform.stamp] = transform.T_parent_child;
}

std::optional<Eigen::Isometry3d> FrameTree::link_at(const Link& link, Stamp stamp) {
  const auto& known = link.T_parent_child;
  if (link.fixed) return known.rbegin()->second;
  const auto after = known.lower_bound(stamp);
  if (after == known.end()) return std::nullopt;
  if (after->first == stamp) return after->second;
  if (after == known.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const double gap_s = seconds(after->first - before->first);
  if (gap_s > kMaxGapS) return std::nullopt;
  return between(before->second, after->second, seconds(stamp - before->first) / gap_s);
}

std::optional<Eigen::Isometry3d> FrameTree::at(const std::string& to, const std::string& from, Stamp stamp) const {
  Eigen::Isometry3d T_here_from = Eigen::Isometry3d::Identity();
  std::string here = from;
  for (int i = 0; here != to && i < kMostLinks; ++i) {
    const auto link = links_.find(here);
    if (link == links_.end()) return std::nullopt;
    const auto T_parent_here = link_at(link->second, stamp);
    if (!T_parent_here) return std::nullopt;
    T_here_from = *T_parent_here * T_here_from;
    here = link->second.parent;
  }
  if (here != to) return std::nullopt;
  return T_here_from;
}

bool FrameTree::hangs_below(const std::string& from, const std::string& to) const {
  std::string here = from;
  for (int i = 0; here != to && i < kMostLinks; ++i) {
    const auto link = links_.find(here);
    if (link == links_.end()) return false;
    here = link->second.parent;
  }
  return here == to;
}

std::map<Stamp, Eigen::Isometry3d> FrameTree::motion(const std::string& parent, const std::string& child) const {
  const auto link = links_.find(child);
  if (link == links_.end() || link->second.parent != parent || link->second.fixed) return {};
  return link->second.T_parent_child;
}

}  // namespace amiss::dataset
