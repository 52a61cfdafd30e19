#include "sim/internal/noise_tables.hpp"

#include <algorithm>
#include <cmath>

namespace amiss::sim::internal {
namespace {

/// Repeat the beginning after the end, so that a row can be read from any place.
template <class T>
void continue_table(std::vector<T>& table, std::size_t more) {
  for (std::size_t i = 0; i < more; ++i) table.push_back(table[i]);
}

void fill_angles(NoiseTables& t) {
  const DepthNoiseParams& p = t.params;
  for (std::size_t byte = 0; byte < t.signal.size(); ++byte) {
    const double cosine = static_cast<double>(byte) / 255.0, angle = std::min(std::acos(cosine), radians(89.0));
    const double flat = angle / (radians(90.0) - angle);
    t.lateral_px[byte] = static_cast<float>(p.lateral_scale * sigma_lateral_px(angle));
    t.flat_m[byte] = static_cast<float>(0.0001 * flat * flat);
    // Half of the pixels are lost at the least signal, none at twice of it.
    const double signal = p.least_signal > 0.0 ? cosine / (2.0 * p.least_signal) : 1e9;
    t.signal[byte] = angle > p.max_incidence_rad ? -1.0F : static_cast<float>(signal / 255.0);
  }
}

void fill_random(NoiseTables& t) {
  RandomStream random(1, "noise tables");
  for (std::size_t i = 0; i < kNoiseValues; ++i) {
    t.normal.push_back(static_cast<float>(random.normal()));
    t.uniform.push_back(static_cast<float>(random.uniform()));
    // What the channels share is brightness, the rest is colour.
    const double shared = 0.8 * random.normal();
    for (int channel = 0; channel < 3; ++channel)
      t.colour.push_back(static_cast<std::int8_t>(
          std::clamp(std::lround(t.params.colour_sigma * (shared + 0.6 * random.normal())), -127L, 127L)));
  }
  continue_table(t.normal, kMaxWidth);
  continue_table(t.uniform, kMaxWidth);
  continue_table(t.colour, 3 * kMaxWidth);
}

}  // namespace

NoiseTables::NoiseTables(const DepthNoiseParams& p, const CameraIntrinsics& c)
    : params(p),
      intrinsics(c),
      steps_m(static_cast<float>(c.fx * p.baseline_m / p.disparity_step_px)),
      max_steps(static_cast<float>(static_cast<double>(steps_m) / p.min_range_m)),
      axial_scale(static_cast<float>(p.axial_scale)) {
  fill_angles(*this);
  fill_random(*this);
}

}  // namespace amiss::sim::internal
