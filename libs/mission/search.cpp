#include "mission/search.hpp"

#include <algorithm>

namespace amiss::mission {

std::vector<knowledge::Sighting> sightings(const std::vector<change::Region>& regions) {
  std::vector<knowledge::Sighting> sightings;
  for (const change::Region& r : regions) {
    const Eigen::Vector3d middle(r.centre_m.x(), r.centre_m.y(), 0.5 * (r.z_low_m + r.z_high_m));
    sightings.push_back({middle, {r.centre_m, r.radius_m, r.z_low_m, r.z_high_m}, static_cast<int>(r.voxels.size())});
  }
  return sightings;
}

Search::Search(robot::Robot& robot, const Reference& reference, knowledge::KnowledgeBase& knowledge,
               const plan::Domain& domain, const Params& params, std::uint64_t seed, bool keep_searching,
               const Sinks& sinks)
    : SearchMethod(robot, reference, knowledge, domain, params, seed, keep_searching, sinks),
      differencer_(reference.reference, reference.floor, params.difference),
      head_(view::head_of(robot.model())) {}

Search::Progress Search::arrived(const Visit& visit) {
  return visit.kind == Visit::Kind::kExplore ? explore(visit) : examine(visit);
}

Search::Progress Search::explore(const Visit& visit) {
  if (!navigator_.stand(params_.search.look_s, {0.0, params_.navigation.navigator.head_tilt_rad})) {
    return Progress::kEnded;
  }
  knowledge_.mark_visited(visit.id, perception_.now());
  open_views_.erase(visit.id);
  return compare() ? Progress::kReplan : Progress::kDone;
}

Search::Progress Search::examine(const Visit& visit) {
  const Stamp begin = perception_.now();
  const robot::HeadState gaze = gaze_.at(visit.id);
  if (const Progress looked = look(gaze); looked != Progress::kDone) return looked;
  compare();
  const knowledge::Region region = knowledge_.now().regions.at(static_cast<std::size_t>(visit.id - 1));
  if (region.withdrawn || region.examined) return Progress::kReplan;

  const segment::Cylinder crop{region.cylinder.centre_map, region.cylinder.radius_m, region.cylinder.z_low_m,
                               region.cylinder.z_high_m};
  const bool segmented = segment(visit.id, gaze, params_.search.segment_region_s, [&](const LocatedFrame& frame) {
    return segment::segment_region(frame.captured.frame, frame.T_map_camera, crop, params_.segment);
  });
  if (!segmented) return Progress::kEnded;
  report_.segmenting += perception_.now() - begin;
  report_progress();
  return Progress::kReplan;
}

Search::Progress Search::failed(const Visit& visit, const std::string& why) {
  SearchMethod::failed(visit, why);
  if (visit.kind == Visit::Kind::kExamine) {
    auto& tried = tried_viewpoints_[visit.id];
    tried.push_back(visit.T_map_base);
    if (static_cast<int>(tried.size()) >= params_.search.viewpoints) given_up_.insert(visit.id);
  }
  return Progress::kReplan;
}

void Search::forget_failures() {
  given_up_.clear();
  tried_viewpoints_.clear();
}

bool Search::compare() {
  const double before = sinks_.wall_clock_ms();
  const change::Difference& difference = differencer_.update(perception_.voxels());
  const auto regions = change::regions(difference.appeared, perception_.voxels(), params_.region);
  sinks_.compared({perception_.now(), sinks_.wall_clock_ms() - before, &difference});
  // The difference speaks of the whole map: a region that is not in it was looked at again and is gone.
  const auto changes = knowledge_.merge(
      sightings(regions), [](const knowledge::Region&) { return true; }, perception_.now());
  next_comparison_ = perception_.now() + duration_of(params_.search.compare_s);
  report_progress();
  return std::any_of(changes.begin(), changes.end(),
                     [](const knowledge::RegionChange& c) { return c.change != knowledge::Change::kGrown; });
}

bool Search::compare_due() { return perception_.now() >= next_comparison_ && compare(); }

}  // namespace amiss::mission
