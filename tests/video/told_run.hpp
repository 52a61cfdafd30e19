// A run that was told: 10 s straight ahead along x of the map in an empty room, one object found, one region.
#pragma once

#include "page/story.hpp"

namespace amiss::test {

inline page::Story told_run() {
  page::Story story;
  story.world = "room";
  story.method = "dynamic";
  story.floor = FloorGrid(0.1, {-2.0, -3.0}, 60, 60, Occupancy::kFree);
  for (int x = 0; x < 60; ++x) story.floor.set({x, 59}, Occupancy::kOccupied);  // a wall at y = 2.95
  for (int i = 0; i <= 50; ++i) {
    const Pose2<Map, Base> pose{0.04 * i, 0.0, 0.0};
    story.poses.push_back({0.2 * i, {pose, pose, {}}});
  }
  story.end_s = 10.0;
  story.place.T_world_map.T.translate(Eigen::Vector3d(5.0, 4.0, 0.0));
  story.place.T_world_map.T.rotate(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ()));
  story.regions = {{2.0, {{1, {1.0, 1.0}, 0.3, false, false}}}, {6.0, {{1, {1.0, 1.0}, 0.3, true, false}}}};
  story.objects = {{0.0, {{"mug", {{1.0, 1.0, 0.05}}, false}}}, {6.0, {{"mug", {{1.0, 1.0, 0.05}}, true}}}};
  Transform<Map, Object> T_map_mug;
  T_map_mug.T.translate(Eigen::Vector3d(1.0, 1.0, 0.05));
  story.bodies = {{0.0, {"mug", "mug", T_map_mug}}};
  story.notes = {{2.0, {page::Note::Kind::kDetected, "region 1 detected"}},
                 {6.0, {page::Note::Kind::kFound, "found mug"}}};
  return story;
}

}  // namespace amiss::test
