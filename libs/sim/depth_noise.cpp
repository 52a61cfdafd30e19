#include "sim/depth_noise.hpp"

#include <algorithm>
#include <cmath>

#include "core/result.hpp"
#include "sim/internal/noise_rows.hpp"
#include "sim/internal/noise_tables.hpp"

namespace amiss::sim {

void describe(ParamTable& table, DepthNoiseParams& p) {
  table.flag("camera.noise", p.enabled, "the camera errs as a structured-light camera does");
  table.number("camera.min_range", p.min_range_m, "m", 0.05, 2.0, "nothing comes back from nearer surfaces");
  table.number("camera.max_range", p.max_range_m, "m", 1.0, 20.0, "nothing comes back from farther surfaces");
  table.number("camera.max_incidence", p.max_incidence_rad, "deg", 10.0, 89.0,
               "angle between ray and normal beyond which nothing comes back");
  table.number("camera.axial_scale", p.axial_scale, "1", 0.0, 10.0, "factor on the axial noise (sigma_z)");
  table.number("camera.lateral_scale", p.lateral_scale, "1", 0.0, 3.0, "factor on the lateral noise (sigma_L)");
  table.number("camera.baseline", p.baseline_m, "m", 0.01, 0.5, "from the camera to the projector on its right");
  table.number("camera.disparity_step", p.disparity_step_px, "px", 0.01, 1.0, "disparity is rounded to multiples");
  table.number("camera.edge_jump", p.edge_jump, "1", 0.005, 1.0, "relative jump of depth that is an edge");
  table.number("camera.edge_loss", p.edge_loss, "1", 0.0, 1.0, "share of the pixels at edges without depth");
  table.number("camera.random_loss", p.random_loss, "1", 0.0, 1.0, "share of all pixels without depth");
  table.number("camera.least_signal", p.least_signal, "1/m^2", 0.0, 1.0,
               "reflectance * cos(incidence) / z^2 at which half of the pixels have no depth");
  table.number("camera.colour_sigma", p.colour_sigma, "1", 0.0, 40.0, "noise of a colour channel of 0 .. 255");
}

double sigma_axial_m(double z_m, double a_rad) {
  const double a = degrees(a_rad), flat = a / (90.0 - a), far = z_m - 0.4;
  return 0.0012 + 0.0019 * far * far + 0.0001 / std::sqrt(z_m) * flat * flat;
}

double sigma_lateral_px(double a_rad) {
  const double a = degrees(a_rad);
  return 0.8 + 0.034 * a / (90.0 - a);
}

struct DepthNoise::Tables : internal::NoiseTables {
  using NoiseTables::NoiseTables;
};

DepthNoise::DepthNoise(const DepthNoiseParams& params, const CameraIntrinsics& intrinsics) {
  if (!(params.min_range_m > 0.0 && params.min_range_m < params.max_range_m))
    throw ArgumentError("camera.min_range must be positive and less than camera.max_range");
  if (intrinsics.width < 1 || intrinsics.height < 1 || static_cast<std::size_t>(intrinsics.width) > internal::kMaxWidth)
    throw ArgumentError("camera intrinsics: width and height must be 1 to 4096");
  tables_ = std::make_shared<const Tables>(params, intrinsics);
}

DepthNoise::~DepthNoise() = default;
DepthNoise::DepthNoise(DepthNoise&&) noexcept = default;
DepthNoise& DepthNoise::operator=(DepthNoise&&) noexcept = default;

RgbdFrame DepthNoise::apply(RenderedFrame&& frame, Stamp stamp, RandomStream& stream) const {
  if (!(frame.intrinsics == tables_->intrinsics))
    throw ArgumentError("the frame was not taken by the camera of this noise model");
  const std::uint64_t seed = stream.next();
  RgbdFrame noisy{stamp, frame.intrinsics, std::move(frame.colour), {}};
  if (!tables_->params.enabled) {
    noisy.depth_m = std::move(frame.depth_m);
    return noisy;
  }
  internal::clean(frame.depth_m);
  noisy.depth_m = internal::noisy_depth(*tables_, frame, seed);
  internal::add_colour_noise(*tables_, noisy.colour, seed);
  return noisy;
}

}  // namespace amiss::sim
