// Which places a search still has to see: view triangles and viewpoints of regions (thesis 4.2.2, 4.2.6, 4.3.2).
#include <algorithm>

#include "mapping/raycast.hpp"
#include "mission/search.hpp"
#include "motion/path_lengths.hpp"

namespace amiss::mission {

namespace {

constexpr double kSameViewpoint = 0.15;  // m

}  // namespace

bool Search::is_pointless(const Visit& visit) {
  if (visit.kind == Visit::Kind::kExamine) {
    return knowledge_.now().regions.at(static_cast<std::size_t>(visit.id - 1)).withdrawn;
  }
  const auto view = open_views_.find(visit.id);
  if (view == open_views_.end()) return true;
  if (!is_covered(view->second)) return false;
  knowledge_.mark_dropped(visit.id);
  open_views_.erase(view);
  return true;
}

bool Search::is_covered(const view::ViewTriangle& view) {
  if (looking_ == Looking::kAgain) return false;
  const double known = view::covered_fraction(view, perception_.obstacles().seen_floor());
  if (looking_ == Looking::kCoarsely) return known > params_.triangle.drop_above;
  const double cell_m = reference_.floor.resolution_m();
  const double unseen_m2 = (1.0 - known) * static_cast<double>(view.floor_m.size()) * cell_m * cell_m;
  return unseen_m2 < 0.5 * params_.search.fine_gain_m2;
}

std::vector<view::ViewTriangle> Search::sample_view_triangles() {
  view::TriangleParams triangle = params_.triangle;
  if (looking_ == Looking::kFinely) {
    triangle.min_gain_m2 = params_.search.fine_gain_m2;
    triangle.coverage_goal = 1.0;
  }
  const FloorGrid nothing;
  auto triangles = sample(looking_ == Looking::kAgain ? nothing : perception_.obstacles().seen_floor(), triangle);
  std::erase_if(triangles, [this](const view::ViewTriangle& t) { return is_covered(t); });
  return triangles;
}

bool Search::add_view_triangles() {
  std::vector<view::ViewTriangle> triangles;
  while (triangles.empty()) {
    if (looking_ != Looking::kAgain && coverage() >= params_.search.explored_at) looking_ = Looking::kAgain;
    if (looking_ == Looking::kAgain && !keep_searching_) return false;
    triangles = sample_view_triangles();
    if (!triangles.empty()) break;
    if (looking_ == Looking::kAgain) return false;
    looking_ = looking_ == Looking::kCoarsely ? Looking::kFinely : Looking::kAgain;
  }
  remember(std::move(triangles));
  return true;
}

std::optional<Visit> Search::viewpoint_of(const knowledge::Region& region, const motion::PathLengths& ways) {
  const knowledge::Cylinder& c = region.cylinder;
  const view::Cylinder cylinder{
      {c.centre_map.x(), c.centre_map.y(), 0.5 * (c.z_low_m + c.z_high_m)}, c.radius_m, c.z_high_m - c.z_low_m};
  const auto clear = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return mapping::line_of_sight(reference_.mapped, a, b);
  };
  const auto poses =
      view::view_poses(cylinder, navigator_.drive_map().grid(), ways.field(), clear, head_, params_.view_pose);
  const auto& tried = tried_viewpoints_[region.id];
  const auto best = std::find_if(poses.begin(), poses.end(), [&](const view::ViewPose& pose) {
    return std::none_of(tried.begin(), tried.end(), [&](const Pose2<Map, Base>& t) {
      return (t.position() - pose.T_map_base.position()).norm() < kSameViewpoint;
    });
  });
  if (best == poses.end()) return std::nullopt;
  gaze_[region.id] = {best->pan_rad, best->tilt_rad};
  return Visit{Visit::Kind::kExamine, region.id, best->T_map_base};
}

std::vector<Visit> Search::open_visits() {
  const motion::PathLengths ways = navigator_.ways_from_here();
  std::vector<Visit> visits =
      open_view_visits(ways, [this](const view::ViewTriangle& view) { return !is_covered(view); });
  for (const knowledge::Region& region : knowledge_.open_regions()) {
    if (given_up_.contains(region.id)) continue;
    if (const auto visit = viewpoint_of(region, ways)) {
      visits.push_back(*visit);
    } else if (open_views_.empty()) {
      given_up_.insert(region.id);
      sinks_.log(perception_.now(), "region " + std::to_string(region.id) + " cannot be seen from anywhere");
    }
  }
  return visits;
}

}  // namespace amiss::mission
