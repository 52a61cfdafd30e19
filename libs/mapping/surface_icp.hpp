// Where a frame was taken, more exactly than the robot's localization says: ICP of its points against the model that
// the frames before it made (5.3.2.1: "the option to refine the pose by aligning the input data to the existing
// structure with ICP").
//
// in: SurfaceMap, RgbdFrame, expected T_map_camera     out: Refinement: the pose, and why it should be believed
//
// The nearest point of the model is not searched: the distance field and its gradient at a point are the distance to
// the surface and its normal (point to plane; Bylow et al. 2013). Gauss-Newton with Huber's weights; the expected pose
// counts as a measurement as well, so that what the model does not hold (the slide along a wall) stays as expected.
// Refused, with the expected pose as it came, when little of the frame lies on the model, the fit is bad or no better
// than before, or the pose left the limits. Errors: ArgumentError for wrong parameters, InputError as
// SurfaceMap::insert.
#pragma once

#include <string>

#include "mapping/surface_map.hpp"

namespace amiss::mapping {

struct RefinementParams {
  bool planar = true;  // a robot on a floor: only x, y and heading are in doubt
  int pixel_step = 8;
  int iterations = 15;
  double expected_shift_m = 0.01, expected_turn_rad = radians(0.5);  // standard deviations of the expected pose
  double max_shift_m = 0.10, max_turn_rad = radians(4.0);            // beyond these the result is not believed
  double min_overlap = 0.3;                                          // of the points that must lie on the model
  double max_rms_voxels = 1.0;                                       // of their distances to it
};
void describe(ParamTable& table, RefinementParams& params);

struct Refinement {
  Transform<Map, Camera> T_map_camera;  // refined, or as expected where refused
  bool accepted = false;
  std::string why;  // refused
  std::size_t points = 0, pairs = 0;
  double rms_before_m = 0.0, rms_after_m = 0.0;  // of the pairs
  double shift_m = 0.0, turn_rad = 0.0;          // from the expected pose
  int iterations = 0;

  [[nodiscard]] double overlap() const {
    return points == 0 ? 0.0 : static_cast<double>(pairs) / static_cast<double>(points);
  }
};

/// `start`: where the search begins, for example the expected pose with the last frame's correction.
[[nodiscard]] Refinement refine_pose(const SurfaceMap& map, const RgbdFrame& frame,
                                     const Transform<Map, Camera>& expected, const Transform<Map, Camera>& start,
                                     const RefinementParams& params = {});

}  // namespace amiss::mapping
