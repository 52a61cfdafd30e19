// Values in the lines of a timeline: JSON -> what a story tells. Frames and units as in page/events.hpp. InputError (or
// nlohmann's exceptions) for what is none.
#pragma once

#include <nlohmann/json.hpp>

#include "page/story.hpp"

namespace amiss::page {

[[nodiscard]] double number(const nlohmann::json& list, std::size_t i);
[[nodiscard]] Eigen::Vector2d point_of(const nlohmann::json& p);
[[nodiscard]] Eigen::Vector3d vector_of(const nlohmann::json& p);
[[nodiscard]] Pose2<Map, Base> pose2_of(const nlohmann::json& p);
[[nodiscard]] Eigen::Isometry3d pose_of(const nlohmann::json& p);
[[nodiscard]] FloorGrid floor_of(const nlohmann::json& json);
[[nodiscard]] std::vector<mapping::Voxel> voxels_of(const nlohmann::json& text);
[[nodiscard]] StoryRobot robot_of(const nlohmann::json& json);

}  // namespace amiss::page
