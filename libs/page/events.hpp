// What a run tells a page: one line of JSON for each event, the same in timeline.jsonl, on the socket and in
// report.html. Values of the stages -> a line without its newline. Map frame, metres, radians, simulated seconds ("t");
// lengths are rounded to millimetres. Voxels are base64 of int16 triplets (x, y, z; little endian), in the order given.
// libs/page/README.md lists all events and their fields.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/floor_grid.hpp"
#include "knowledge/knowledge_base.hpp"
#include "mapping/voxel_map.hpp"
#include "mission/sinks.hpp"
#include "robot/model.hpp"

namespace amiss::page {

inline constexpr int kSchema = 1;

/// Where a run took place, so that its film can be made from its run folder.
struct Place {
  std::string world;  // as `amiss tidy --world` takes it
  std::string robot;  // URDF file; empty: the robot of amiss
  Transform<World, Map> T_world_map;
};

/// What the page of a run begins with.
struct Beginning {
  std::string version, world, method;
  std::uint64_t seed = 0;
  const FloorGrid* floor = nullptr;              // of the reference
  const mapping::VoxelMap* reference = nullptr;  // as mapped, not dilated
  const robot::Model* model = nullptr;
  double max_error_m = 0.0, min_cover = 0.0, min_purity = 0.0;  // what the referee asks for
  Place place = {};
};

/// An object that was placed, and what the referee says of it. For people: nothing of it goes back to the robot.
struct PlacedObject {
  std::string name, kind;
  Point<Map> place;  // true
  bool found = false, covered = false;
  double found_at_s = 0.0, error_m = 0.0;
  double cover = 0.0, purity = 0.0;  // of the segment that counted or came nearest
  bool operator==(const PlacedObject& other) const;
};

/// Something that lies or stands about and can move, and where it truly is.
struct MovableBody {
  std::string name, kind;  // kind: in the catalogue; empty: the world's own
  Transform<Map, Object> T_map_body;
};

/// A touch of something by the robot.
struct Touch {
  Stamp stamp;
  std::string link, body;
  Point<Map> place;
};

/// What a script did to the world or to the robot.
struct Occurrence {
  Stamp stamp;
  std::string text;
};

/// Bytes of a picture in camera.bin.
struct Slice {
  std::size_t begin = 0, bytes = 0;
};

[[nodiscard]] std::string voxels_text(std::span<const mapping::Voxel> voxels);

[[nodiscard]] std::string start_line(const Beginning& beginning);
[[nodiscard]] std::string pose_line(const mission::StepEvent& step, const Pose2<Map, Base>& truth);
[[nodiscard]] std::string progress_line(const mission::ProgressEvent& event, int found);
[[nodiscard]] std::string voxels_line(Stamp stamp, std::span<const mapping::Voxel> occupied,
                                      std::span<const mapping::Voxel> cleared);
[[nodiscard]] std::string difference_line(Stamp stamp, const change::Difference& difference);
[[nodiscard]] std::string regions_line(Stamp stamp, const std::vector<knowledge::Region>& regions);
[[nodiscard]] std::string views_line(Stamp stamp, const std::vector<knowledge::View>& views);
[[nodiscard]] std::string plan_line(const mission::PlanEvent& event);
[[nodiscard]] std::string step_line(const mission::ActionEvent& event);
[[nodiscard]] std::string path_line(const mission::PathEvent& event);
[[nodiscard]] std::string frame_line(Stamp taken, Slice colour, Slice depth);
[[nodiscard]] std::string examined_line(const mission::ExaminationEvent& event, Slice picture);
[[nodiscard]] std::string objects_line(Stamp stamp, const std::vector<PlacedObject>& objects);
/// Bodies that are where they were not, and names of those that are gone.
[[nodiscard]] std::string bodies_line(Stamp stamp, const std::vector<MovableBody>& bodies,
                                      const std::vector<std::string>& gone);
[[nodiscard]] std::string collision_line(const Touch& touch);
[[nodiscard]] std::string script_line(const Occurrence& occurrence);
[[nodiscard]] std::string log_line(Stamp stamp, std::string_view text);
/// `report_json`: an object, as in report.json or report.partial.json.
[[nodiscard]] std::string end_line(Stamp stamp, std::string_view report_json);

}  // namespace amiss::page
