// Materials that an SDF names instead of describing: Gazebo's own colours, and OGRE material scripts in files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "world/world.hpp"

namespace amiss::world {

/// The plain colour of a well-known name such as "Gazebo/White".
[[nodiscard]] std::optional<Eigen::Vector3f> gazebo_colour(const std::string& name);

struct ScriptMaterial {
  Material material;              // its texture still to be loaded
  std::filesystem::path texture;  // empty where there is none, else a file that exists
};

/// The material `name` in the .material files of `places` (files or folders), textures searched beside and around them.
[[nodiscard]] std::optional<ScriptMaterial> find_script_material(const std::string& name,
                                                                 const std::vector<std::filesystem::path>& places);

}  // namespace amiss::world
