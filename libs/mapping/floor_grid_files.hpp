// Floor grids as ROS' map_server stores them: map.yaml (image, resolution, origin, negate, occupied_thresh,
// free_thresh) beside map.pgm (P2 or P5, top row = largest y).
//
// in: map.yaml     out: FloorGrid in the map frame [m], or InputError that names file, key and what is allowed.
// A pixel's darkness p = (max - value) / max (value / max when negate) is occupied above occupied_thresh, free below
// free_thresh, unknown between. Only yaw = 0 is allowed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/floor_grid.hpp"

namespace amiss::mapping {

[[nodiscard]] FloorGrid load_floor_grid(const std::filesystem::path& yaml_file);
/// Writes FILE.yaml and FILE.pgm beside it; the image first, each of them whole or not at all.
void save_floor_grid(const std::filesystem::path& yaml_file, const FloorGrid& grid);

/// What load_floor_grid makes of the two files' bytes; `name` stands in the errors.
struct FloorGridHeader {
  std::string image;
  double resolution_m = 0.05;
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
  bool negate = false;
  double occupied_threshold = 0.65, free_threshold = 0.196;
};
[[nodiscard]] FloorGridHeader parse_floor_grid_header(std::string_view yaml, const std::string& name);
[[nodiscard]] FloorGrid parse_floor_grid(const FloorGridHeader& header, std::string_view pgm, const std::string& name);

}  // namespace amiss::mapping
