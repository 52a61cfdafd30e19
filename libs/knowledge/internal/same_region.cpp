#include "knowledge/internal/same_region.hpp"

#include <algorithm>
#include <numbers>
#include <tuple>

namespace amiss::knowledge::internal {

double shared_part(const Cylinder& a, const Cylinder& b) {
  const double d = (a.centre_map - b.centre_map).norm();
  const double small = std::min(a.radius_m, b.radius_m), large = std::max(a.radius_m, b.radius_m);
  if (d >= small + large) return 0.0;
  if (d <= large - small) return 1.0;
  // Two circular segments on the common chord.
  const double cos_small = std::clamp((d * d + small * small - large * large) / (2.0 * d * small), -1.0, 1.0);
  const double cos_large = std::clamp((d * d + large * large - small * small) / (2.0 * d * large), -1.0, 1.0);
  const double half_small = std::acos(cos_small), half_large = std::acos(cos_large);
  const double area = small * small * (half_small - std::sin(half_small) * cos_small) +
                      large * large * (half_large - std::sin(half_large) * cos_large);
  return area / (std::numbers::pi * small * small);
}

bool same_region(const Cylinder& a, const Cylinder& b, const Params& params) {
  const double d = (a.centre_map - b.centre_map).norm();
  return d < params.same_distance * std::max(a.radius_m, b.radius_m) || shared_part(a, b) >= params.same_overlap;
}

Cylinder enclosing(const Cylinder& a, const Cylinder& b) {
  Cylinder out;
  out.z_low_m = std::min(a.z_low_m, b.z_low_m);
  out.z_high_m = std::max(a.z_high_m, b.z_high_m);
  const Eigen::Vector2d between = b.centre_map - a.centre_map;
  const double d = between.norm();
  const Cylinder& large = a.radius_m >= b.radius_m ? a : b;
  const Cylinder& small = a.radius_m >= b.radius_m ? b : a;
  out.centre_map = large.centre_map;
  out.radius_m = large.radius_m;
  if (d + small.radius_m <= large.radius_m) return out;
  out.radius_m = (d + a.radius_m + b.radius_m) / 2.0;
  out.centre_map = a.centre_map + between / d * (out.radius_m - a.radius_m);
  return out;
}

std::vector<Sighting> joined(std::vector<Sighting> sightings, const Params& params) {
  const auto before = [](const Sighting& a, const Sighting& b) {
    const auto key = [](const Sighting& s) {
      return std::make_tuple(s.position_map.x(), s.position_map.y(), s.position_map.z(), s.cylinder.radius_m, s.voxels);
    };
    return key(a) < key(b);
  };
  std::sort(sightings.begin(), sightings.end(), before);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < sightings.size() && !changed; ++i) {
      for (std::size_t j = i + 1; j < sightings.size() && !changed; ++j) {
        Sighting &a = sightings[i], &b = sightings[j];
        if (!same_region(a.cylinder, b.cylinder, params)) continue;
        a.cylinder = enclosing(a.cylinder, b.cylinder);
        a.position_map << a.cylinder.centre_map, (a.cylinder.z_low_m + a.cylinder.z_high_m) / 2.0;
        a.voxels += b.voxels;
        sightings.erase(sightings.begin() + static_cast<std::ptrdiff_t>(j));
        changed = true;
      }
    }
  }
  std::sort(sightings.begin(), sightings.end(), before);
  return sightings;
}

bool grown_noticeably(const Cylinder& then, const Cylinder& now, const Params& params) {
  const double height_then = then.z_high_m - then.z_low_m, height_now = now.z_high_m - now.z_low_m;
  const double factor = 1.0 + params.noticeable_growth;
  const bool wider = now.radius_m * now.radius_m > factor * then.radius_m * then.radius_m &&
                     now.radius_m - then.radius_m > params.noticeable_m;
  const bool higher = height_now > factor * height_then && height_now - height_then > params.noticeable_m;
  return wider || higher;
}

}  // namespace amiss::knowledge::internal
