// An instant of a run as a scene that MRPT's SceneViewer3D opens (.3Dscene: a serialized COpenGLScene, gzipped): floor
// plan and metric grid, voxels (what only the reference holds, what the robot's map holds, what appeared, what
// vanished: no voxel twice), view triangles, way driven and wanted, regions as cylinders, segments as boxes, objects
// and regions with letters (O open, E examined; F found, M missed), the robot. Story, instant -> bytes or file. Map
// frame, metres. A reconstructed room likewise: its points in their colours, the way of the camera. The same input
// gives the same bytes. save: std::runtime_error where the file cannot be written; a file that was there is replaced as
// a whole or stays.
#pragma once

#include <filesystem>
#include <string>

#include "page/story.hpp"

namespace amiss::page {

[[nodiscard]] std::string scene_bytes(const Story& story, double t_s);
[[nodiscard]] std::string scene_bytes(const Cloud<Map>& points, const std::vector<Eigen::Vector3d>& camera_way);
/// What scene_bytes gives, as a file.
void save_scene(const std::filesystem::path& file, const std::string& bytes);

}  // namespace amiss::page
