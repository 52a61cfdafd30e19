// The frame buffer that the renderer draws into: colour, packed facts and depth, row 0 on top.
#pragma once

#include <Eigen/Core>

#include "sim/internal/gl_functions.hpp"
#include "sim/renderer.hpp"

namespace amiss::sim::internal {

class FrameTargets {
 public:
  /// Make it this large; std::runtime_error when GL cannot.
  void resize(const GlFunctions& gl, int width, int height);
  /// Bind and clear.
  void begin(const GlFunctions& gl, const Eigen::Vector3f& background) const;
  /// Transfer what was drawn.
  void read(const GlFunctions& gl, const RenderOptions& options, RenderedFrame& frame);
  void release(const GlFunctions& gl);

 private:
  int width_ = 0, height_ = 0;
  GLuint framebuffer_ = 0;
  GLuint buffers_[3] = {0, 0, 0};  // colour, facts, depth
  std::vector<std::uint32_t> scratch_;
};

}  // namespace amiss::sim::internal
