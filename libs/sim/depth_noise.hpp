// What a structured-light camera (Asus Xtion) makes of a perfect picture.
//
// RenderedFrame -> RgbdFrame of the same size, depth NaN where nothing came back. Axial and lateral noise after Nguyen,
// Izadi and Lovell 2012 ("Modeling Kinect sensor noise for improved 3D reconstruction and tracking"), quantised
// disparity, no return when too near, too far, at a grazing angle, in the shadow of the projector (which stands
// `baseline` to the right of the camera), at depth edges and from surfaces that send too little light back.
// The same stream gives the same frame. Errors: ArgumentError where the parameters contradict each other.
#pragma once

#include <memory>

#include "core/params.hpp"
#include "core/random.hpp"
#include "core/sensors.hpp"
#include "sim/renderer.hpp"

namespace amiss::sim {

struct DepthNoiseParams {
  bool enabled = true;  // false: perfect depth and colour
  double min_range_m = 0.4;
  double max_range_m = 8.0;
  double max_incidence_rad = radians(80);
  double axial_scale = 1.0;    // factor on sigma_axial
  double lateral_scale = 1.0;  // factor on sigma_lateral
  double baseline_m = 0.075;
  double disparity_step_px = 0.125;
  double edge_jump = 0.03;      // a relative jump of depth between neighbours that is an edge
  double edge_loss = 0.4;       // probability that a pixel at an edge has no depth
  double random_loss = 0.002;   // probability anywhere
  double least_signal = 0.001;  // reflectance * cos(incidence) / z^2 [1/m^2] below which half of the pixels are lost
  double colour_sigma = 2.5;    // of each channel, 0 .. 255
};
void describe(ParamTable& table, DepthNoiseParams& params);

/// Standard deviations of Nguyen et al. 2012, z in metres, a the angle of incidence.
[[nodiscard]] double sigma_axial_m(double z_m, double a_rad);
[[nodiscard]] double sigma_lateral_px(double a_rad);

class DepthNoise {
 public:
  DepthNoise(const DepthNoiseParams& params, const CameraIntrinsics& intrinsics);
  ~DepthNoise();
  DepthNoise(DepthNoise&&) noexcept;
  DepthNoise& operator=(DepthNoise&&) noexcept;

  /// Consumes one number of the stream for each frame. Threads may share a DepthNoise.
  /// ArgumentError when the frame was not taken with the intrinsics of the constructor.
  [[nodiscard]] RgbdFrame apply(RenderedFrame&& frame, Stamp stamp, RandomStream& stream) const;

 private:
  struct Tables;
  std::shared_ptr<const Tables> tables_;
};

}  // namespace amiss::sim
