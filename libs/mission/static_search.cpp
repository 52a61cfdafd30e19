#include "mission/static_search.hpp"

namespace amiss::mission {

std::vector<Visit> StaticSearch::open_visits() {
  return open_view_visits(navigator_.ways_from_here(), [](const view::ViewTriangle&) { return true; });
}

bool StaticSearch::add_view_triangles() {
  auto triangles = sample(segmented_floor_, params_.triangle);
  if (triangles.empty() && keep_searching_) {
    segmented_floor_ = {};
    triangles = sample(segmented_floor_, params_.triangle);
  }
  if (triangles.empty()) return false;
  remember(std::move(triangles));
  return true;
}

StaticSearch::Progress StaticSearch::arrived(const Visit& visit) {
  const Stamp begin = perception_.now();
  const robot::HeadState gaze{0.0, params_.navigation.navigator.head_tilt_rad};
  if (const Progress looked = look(gaze); looked != Progress::kDone) return looked;
  const bool segmented = segment(0, gaze, params_.search.segment_frame_s, [this](const LocatedFrame& frame) {
    return segment::segment_frame(frame.captured.frame, frame.T_map_camera, params_.segment);
  });
  if (!segmented) return Progress::kEnded;
  knowledge_.mark_visited(visit.id, perception_.now());
  mark_segmented(open_views_.at(visit.id));
  open_views_.erase(visit.id);
  report_.segmenting += perception_.now() - begin;
  report_progress();
  return Progress::kDone;
}

void StaticSearch::mark_segmented(const view::ViewTriangle& view) {
  if (segmented_floor_.cells().empty()) {
    const FloorGrid& floor = reference_.floor;
    segmented_floor_ = FloorGrid(floor.resolution_m(), floor.origin_m(), floor.width(), floor.height());
  }
  for (const Eigen::Vector2f& p : view.floor_m) {
    const Cell cell = segmented_floor_.cell_at(p.cast<double>());
    if (segmented_floor_.contains(cell)) segmented_floor_.set(cell, Occupancy::kFree);
  }
}

}  // namespace amiss::mission
