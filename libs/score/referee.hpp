// Who alone knows the truth while a mission runs: was an object found, were regions false, how far off was the pose?
// Segments of examinations + instance ids of their frame + true places -> verdicts. Nothing here is told to the robot
// but, by the app, that it may stop.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/params.hpp"
#include "world/truth.hpp"

namespace amiss::score {

struct RefereeParams {
  double max_error_m = 0.10;      // between a segment's centre and the middle of the object's true bounds
  double min_cover = 0.5;         // part of the object's pixels in the frame that the segment holds
  double min_purity = 0.5;        // part of the segment's pixels that show the object
  double region_margin_m = 0.10;  // round an object's bounds: a region that touches this is not false
};
void describe(ParamTable& table, RefereeParams& p);

/// One segment of an examination, with the pixels of the frame that was segmented.
struct JudgedSegment {
  std::span<const std::uint32_t> pixels;  // row-major
  Point<Map> centre;
};

struct ObjectVerdict {
  std::string name, kind;
  Eigen::Vector3d position_world = Eigen::Vector3d::Zero();  // middle of the true bounds
  bool found = false;
  double found_at_s = 0.0;    // simulated
  double error_m = 0.0;       // of the segment that counted, else of the best that covered it
  bool covered = false;       // some segment covered it, near enough or not
  double cover = 0.0;         // part of the object's pixels in that segment, or in the one that held most of them
  double purity = 0.0;        // part of that segment's pixels that show the object
  Point<Map> found_position;  // of that segment
};

class Referee {
 public:
  /// `T_world_map`: how the robot's map lies in the world (score/alignment.hpp).
  Referee(const std::vector<world::ObjectTruth>& placed, const Transform<World, Map>& T_world_map,
          const RefereeParams& params);

  /// An object that was put there later.
  void place(const world::ObjectTruth& object);

  /// Judges the segments of one frame at `now`; `objects` are the true places at the time of the frame. Returns the
  /// names of objects that were found by it for the first time.
  std::vector<std::string> judge(Stamp now, std::span<const JudgedSegment> segments,
                                 const world::InstanceImage& instances, const std::vector<world::ObjectTruth>& objects);

  /// Segments of all frames judged so far, and those of them that show none of the objects with min_purity of their
  /// pixels. A segment of an object that was found before, or only of a part of one, is not false.
  [[nodiscard]] int segments() const { return segments_; }
  [[nodiscard]] int false_segments() const { return false_segments_; }

  [[nodiscard]] bool all_found() const;
  [[nodiscard]] int found() const;
  [[nodiscard]] const std::vector<ObjectVerdict>& verdicts() const { return verdicts_; }

  /// Does a region, a circle on the floor of the map, hold none of the objects?
  [[nodiscard]] bool is_false(const Point<Map>& centre, double radius_m,
                              const std::vector<world::ObjectTruth>& objects) const;

 private:
  [[nodiscard]] bool shows_an_object(const JudgedSegment& segment, const world::InstanceImage& instances) const;

  std::vector<std::uint16_t> instances_;  // as verdicts_
  std::vector<ObjectVerdict> verdicts_;
  Transform<World, Map> T_world_map_;
  RefereeParams params_;
  int segments_ = 0, false_segments_ = 0;
};

}  // namespace amiss::score
