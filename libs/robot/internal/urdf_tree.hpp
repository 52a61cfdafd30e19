// A parsed URDF -> links and joints in an order in which parents come before children.
#pragma once

#include <filesystem>
#include <string>

#include "robot/model.hpp"

namespace amiss::robot {

/// Name, links, joints and warnings of the model; InputError when the text is no tree of links.
[[nodiscard]] Model read_urdf_tree(const std::string& text, const std::filesystem::path& urdf);

}  // namespace amiss::robot
