// Is the depth camera to be believed? Frames with where the robot says it was -> which of them to use, and what is
// wrong. Depth that repeats itself to the last bit while the camera moves is stuck; depth whose neighbours have nothing
// to do with each other is garbage; depth that ends under the floor, or all of it nearer than the floor by one factor
// wherever the robot looks, is wrong. The floor is the plane z = 0 of the base frame.
#pragma once

#include <optional>

#include "mission/trouble.hpp"
#include "robot/robot.hpp"

namespace amiss::mission {

class CameraHealth {
 public:
  explicit CameraHealth(const HealthParams& params) : params_(params) {}

  /// Should this frame be used? Stamps do not go back.
  bool accept(const robot::CapturedFrame& captured);
  [[nodiscard]] std::optional<Trouble> trouble(Stamp now) const;

 private:
  bool repeats(const robot::CapturedFrame& captured);
  void watch_scale(const robot::CapturedFrame& captured, bool is_short);

  HealthParams params_;
  std::optional<robot::CapturedFrame> last_;  // without its colours
  Stamp heard_;                               // last frame that was used
  std::optional<Stamp> stuck_since_, bad_since_, short_since_;
  Complaint bad_ = Complaint::kGarbage;
  int bad_frames_ = 0;        // in a row
  double short_way_m_ = 0.0;  // driven while all frames were short
  double short_turn_rad_ = 0.0;
};

/// Of the floor as a frame shows it, against where it should be.
struct FloorScale {
  double too_long = 0.0;  // part of the rays towards the floor that end far behind it
  double median = 1.0;    // of measured over expected depth
  double alike = 0.0;     // part of the rays near the median
};
[[nodiscard]] FloorScale floor_scale(const RgbdFrame& frame, const Transform<Base, Camera>& T_base_camera);

/// Part of the pixels with depth whose neighbour lies about as deep.
[[nodiscard]] double coherent_part(const RgbdFrame& frame);

}  // namespace amiss::mission
