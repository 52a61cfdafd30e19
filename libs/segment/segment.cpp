#include "segment/segment.hpp"

#include <algorithm>
#include <limits>

#include "core/result.hpp"
#include "segment/internal/extent.hpp"
#include "segment/internal/ground.hpp"
#include "segment/internal/pieces.hpp"
#include "segment/internal/window.hpp"

namespace amiss::segment {

namespace {

using internal::Piece;
using internal::Window;

constexpr double kStructureContactM = 0.06;  // a longer border with the outside of the crop makes a wall or furniture
constexpr double kCutContactM = 0.01;

Eigen::Vector2d centroid_of(const Piece& piece, const Window& window) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const std::uint32_t i : piece.members) sum += window.points[i].head<2>().cast<double>();
  return sum / static_cast<double>(piece.members.size());
}

/// Does it belong to something that stands outside of the region?
bool is_structure(const Piece& piece, const Window& window, const Cylinder& region) {
  if (piece.contact_m < kStructureContactM) return false;
  return !std::isfinite(region.radius_m) || (centroid_of(piece, window) - region.centre_map).norm() > region.radius_m;
}

Segment segment_of(const Piece& piece, const Window& window, const internal::Relief& relief, const Plane& ground) {
  Segment segment;
  double height = 0.0;
  Eigen::Vector3d colour = Eigen::Vector3d::Zero();
  for (const std::uint32_t i : piece.members) {
    segment.pixels.push_back(window.pixel_of(i));
    segment.cloud.points.push_back(window.points[i]);
    segment.cloud.colours.push_back(window.colours[i]);
    segment.cloud.normals.push_back(relief.normals[i]);
    height += static_cast<double>(relief.height_m[i]);
    colour += Eigen::Vector3d(window.colours[i].r, window.colours[i].g, window.colours[i].b);
  }
  const auto n = static_cast<double>(piece.members.size());
  colour = (colour / n).array().round();
  segment.points = static_cast<int>(piece.members.size());
  segment.mean_height_m = height / n;
  segment.mean_colour = {static_cast<std::uint8_t>(colour.x()), static_cast<std::uint8_t>(colour.y()),
                         static_cast<std::uint8_t>(colour.z())};
  segment.cut = piece.at_image_border || piece.contact_m > kCutContactM;
  const internal::Extent extent = internal::extent_of(segment.cloud.points, ground);
  segment.centre_map = extent.centre_map;
  segment.size_m = extent.size_m;
  segment.yaw_rad = extent.yaw_rad;
  return segment;
}

double lowest_of(const Piece& piece, const internal::Relief& relief) {
  float low = std::numeric_limits<float>::infinity();
  for (const std::uint32_t i : piece.members) low = std::min(low, relief.height_m[i]);
  return static_cast<double>(low);
}

Segmentation segmentation_of(const Window& window, const Cylinder& region, const Params& params) {
  Segmentation out;
  out.points_in_crop = static_cast<int>(std::count(window.where.begin(), window.where.end(), internal::Where::kInside));
  out.ground = internal::ground_of(window, params);
  const Plane ground = out.ground.value_or(Plane{});  // the map's own floor where the frame shows none
  const internal::Relief relief = internal::relief_of(window, ground, params);
  out.points_above_ground = static_cast<int>(std::count(relief.standing.begin(), relief.standing.end(), true));

  std::vector<Piece> pieces = internal::pieces_of(window, relief, params);
  out.pieces = static_cast<int>(pieces.size());
  out.dropped =
      static_cast<int>(std::erase_if(pieces, [&](const Piece& piece) { return is_structure(piece, window, region); }));
  for (const Piece& cluster : internal::joined(pieces, window, params)) {
    const bool small = cluster.members.size() < static_cast<std::size_t>(params.min_points);
    if (small || lowest_of(cluster, relief) > params.max_base_m || is_structure(cluster, window, region)) {
      ++out.dropped;
      continue;
    }
    Segment segment = segment_of(cluster, window, relief, ground);
    const bool large = segment.size_m.x() > params.max_size_m || segment.size_m.z() > params.max_height_m;
    if (large) {
      ++out.dropped;
    } else {
      out.segments.push_back(std::move(segment));
    }
  }
  std::sort(out.segments.begin(), out.segments.end(), [](const Segment& a, const Segment& b) {
    return a.points != b.points ? a.points > b.points : a.pixels.front() < b.pixels.front();
  });
  return out;
}

void check(const RgbdFrame& frame) {
  const std::size_t pixels =
      static_cast<std::size_t>(frame.intrinsics.width) * static_cast<std::size_t>(frame.intrinsics.height);
  if (frame.depth_m.size() != pixels || frame.colour.size() != pixels) {
    throw ArgumentError("A frame to segment has " + std::to_string(frame.depth_m.size()) + " depths and " +
                        std::to_string(frame.colour.size()) + " colours; both must be width times height, " +
                        std::to_string(pixels) + ".");
  }
}

}  // namespace

Segmentation segment_region(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera, const Cylinder& region,
                            const Params& params) {
  check(frame);
  Cylinder crop = region;
  crop.radius_m += params.crop_margin_m;
  crop.z_low_m -= params.crop_margin_m;
  crop.z_high_m += params.crop_margin_m;
  return segmentation_of(internal::window_of(frame, T_map_camera, crop, params.max_range_m), region, params);
}

Segmentation segment_frame(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera, const Params& params) {
  check(frame);
  Cylinder all;
  all.radius_m = std::numeric_limits<double>::infinity();
  all.z_low_m = -std::numeric_limits<double>::infinity();
  all.z_high_m = params.max_height_m + params.crop_margin_m;
  return segmentation_of(internal::window_of(frame, T_map_camera, all, params.max_range_m), all, params);
}

}  // namespace amiss::segment
