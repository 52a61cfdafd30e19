// One shader program of the renderer and its uniforms.
#pragma once

#include <string>

#include "sim/internal/gl_functions.hpp"

namespace amiss::sim::internal {

struct GlProgram {
  GLuint id = 0;
  GLint T_camera_body = -1, R_world_body = -1, instance = -1, two_sided = -1;  // of each draw call
  GLint lens = -1, depth_range = -1, ray = -1;                                 // of each picture
  GLint ambient = -1, light_direction = -1, light_colour = -1, picture = -1;   // of the world
};

/// Compile the shaders with these #define lines; std::runtime_error with the compiler's words when that fails.
[[nodiscard]] GlProgram make_program(const GlFunctions& gl, const std::string& defines);

}  // namespace amiss::sim::internal
