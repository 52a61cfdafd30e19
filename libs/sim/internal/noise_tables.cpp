#include "sim/internal/noise_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace amiss::sim::internal {
namespace {

constexpr double kAngleStep = radians(2.0);
constexpr std::size_t kTooFlat = kAngleBins - 1;  // the bin of angles at which nothing comes back

double middle_of(std::size_t angle_bin) {
  return std::min((static_cast<double>(angle_bin) + 0.5) * kAngleStep, radians(89.0));
}

/// Repeat the beginning after the end, so that a row can be read from any place.
template <class T>
void continue_table(std::vector<T>& table, std::size_t more) {
  for (std::size_t i = 0; i < more; ++i) table.push_back(table[i]);
}

void fill_angles(NoiseTables& t) {
  for (std::size_t byte = 0; byte < t.angle_bin.size(); ++byte) {
    const double angle = std::acos(static_cast<double>(byte) / 255.0);
    const auto bin = static_cast<std::size_t>(angle / kAngleStep);
    t.angle_bin[byte] =
        static_cast<std::uint8_t>(angle > t.params.max_incidence_rad ? kTooFlat : std::min(bin, kTooFlat - 1));
  }
  for (std::size_t bin = 0; bin < kAngleBins; ++bin)
    t.lateral_px[bin] = static_cast<float>(t.params.lateral_scale * sigma_lateral_px(middle_of(bin)));
}

/// Rounding to steps adds step^2 / 12 to the variance, so the noise before it is that much smaller.
double sigma_before_rounding(double sigma_steps) {
  return std::sqrt(std::max(sigma_steps * sigma_steps - 1.0 / 12.0, 0.0));
}

void fill_steps(NoiseTables& t) {
  const DepthNoiseParams& p = t.params;
  for (std::size_t step = 0; step <= t.max_step + 1; ++step) {
    const double z = static_cast<double>(t.steps_m) / std::max(static_cast<double>(step), 0.5);
    const bool in_range = z >= p.min_range_m && z <= p.max_range_m;
    t.depth_of_step.push_back(in_range ? static_cast<float>(z) : std::numeric_limits<float>::quiet_NaN());
    for (std::size_t bin = 0; bin < kAngleBins; ++bin) {
      const double angle = middle_of(bin), steps_per_m = static_cast<double>(t.steps_m) / (z * z);
      const double sigma = p.axial_scale * sigma_axial_m(z, angle) * steps_per_m;
      t.axial_steps.push_back(static_cast<float>(sigma_before_rounding(sigma)));
      // Half of the pixels are lost at the least signal, none at twice of it.
      const double signal = p.least_signal > 0.0 ? std::cos(angle) / (z * z) / (2.0 * p.least_signal) : 1e9;
      t.signal.push_back(bin == kTooFlat ? -1.0F : static_cast<float>(signal / 255.0));
    }
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
      max_step(static_cast<std::size_t>(static_cast<double>(steps_m) / p.min_range_m)) {
  fill_angles(*this);
  fill_steps(*this);
  fill_random(*this);
}

}  // namespace amiss::sim::internal
