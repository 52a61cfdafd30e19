// A reconstructed room in a scene: Cloud, way of the camera -> named objects of MRPT. Map frame, metres.
#pragma once

#include <mrpt/opengl/COpenGLScene.h>

#include <vector>

#include "core/frames.hpp"

namespace amiss::page {

/// "points", "camera".
void add_cloud(mrpt::opengl::COpenGLScene& scene, const Cloud<Map>& points,
               const std::vector<Eigen::Vector3d>& camera_way);

}  // namespace amiss::page
