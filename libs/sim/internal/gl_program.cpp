#include "sim/internal/gl_program.hpp"

#include <array>
#include <stdexcept>

#include "sim/internal/shaders.hpp"

namespace amiss::sim::internal {
namespace {

GLuint compile(const GlFunctions& gl, GLenum kind, const std::string& defines, const char* source) {
  const std::string text = "#version 330 core\n" + defines + source;
  const char* c_text = text.c_str();
  const GLuint shader = gl.CreateShader(kind);
  gl.ShaderSource(shader, 1, &c_text, nullptr);
  gl.CompileShader(shader);
  GLint good = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == GL_FALSE) {
    std::array<char, 1024> words{};
    gl.GetShaderInfoLog(shader, static_cast<GLsizei>(words.size()), nullptr, words.data());
    throw std::runtime_error(std::string("OSMesa cannot compile a shader: ") + words.data());
  }
  return shader;
}

}  // namespace

GlProgram make_program(const GlFunctions& gl, const std::string& defines) {
  GlProgram program;
  program.id = gl.CreateProgram();
  for (const GLuint shader : {compile(gl, GL_VERTEX_SHADER, defines, kVertexShader),
                              compile(gl, GL_FRAGMENT_SHADER, defines, kFragmentShader)}) {
    gl.AttachShader(program.id, shader);
    gl.DeleteShader(shader);
  }
  gl.LinkProgram(program.id);
  GLint good = GL_FALSE;
  gl.GetProgramiv(program.id, GL_LINK_STATUS, &good);
  if (good == GL_FALSE) {
    std::array<char, 1024> words{};
    gl.GetProgramInfoLog(program.id, static_cast<GLsizei>(words.size()), nullptr, words.data());
    throw std::runtime_error(std::string("OSMesa cannot link a shader program: ") + words.data());
  }
  const auto uniform = [&](const char* name) { return gl.GetUniformLocation(program.id, name); };
  program.T_camera_body = uniform("T_camera_body");
  program.R_world_body = uniform("R_world_body");
  program.instance = uniform("instance");
  program.two_sided = uniform("two_sided");
  program.lens = uniform("lens");
  program.depth_range = uniform("depth_range");
  program.ray = uniform("ray");
  program.ambient = uniform("ambient");
  program.light_direction = uniform("light_direction");
  program.light_colour = uniform("light_colour");
  program.picture = uniform("picture");
  return program;
}

}  // namespace amiss::sim::internal
