// A script of small changes: bodies of a world that stand a little elsewhere on one visit (furniture that was pushed, a
// keyboard that was turned). World and nudges -> the world with these bodies moved. Files are a YAML list of
// {body: NAME, [x], [y], [yaw_deg]}: first turned about its own origin (about the vertical), then shifted [m, world].
// Errors: InputError with file and line; a body that the world does not have comes with the nearest name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "world/world.hpp"

namespace amiss::world {

struct Nudge {
  std::string body;
  Eigen::Vector2d shift_m = Eigen::Vector2d::Zero();
  double yaw_rad = 0.0;
};

/// The pose of a body that was nudged.
[[nodiscard]] Transform<amiss::World, Object> nudged(const Transform<amiss::World, Object>& pose, const Nudge& nudge);
/// ArgumentError with the nearest name for a body that is not there.
[[nodiscard]] World nudged(World world, const std::vector<Nudge>& nudges);

[[nodiscard]] std::vector<Nudge> load_nudges(const std::filesystem::path& file, const World& world);
void save_nudges(const std::filesystem::path& file, const std::vector<Nudge>& nudges);

}  // namespace amiss::world
