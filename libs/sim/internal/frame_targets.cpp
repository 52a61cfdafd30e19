#include "sim/internal/frame_targets.hpp"

#include <limits>
#include <stdexcept>

#include "sim/internal/wide.hpp"

namespace amiss::sim::internal {
namespace {

/// Four bytes a pixel -> three.
AMISS_WIDE void drop_alpha(const std::uint32_t* rgba, Rgb* colour, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    colour[i] = {static_cast<std::uint8_t>(rgba[i]), static_cast<std::uint8_t>(rgba[i] >> 8U),
                 static_cast<std::uint8_t>(rgba[i] >> 16U)};
}

AMISS_WIDE void unpack(const std::uint32_t* facts, RenderedFrame& frame, std::size_t count) {
  std::uint16_t* instances = frame.instances.data();
  std::uint8_t* reflectance = frame.reflectance.data();
  std::uint8_t* incidence = frame.incidence.data();
  for (std::size_t i = 0; i < count; ++i) instances[i] = static_cast<std::uint16_t>(facts[i]);
  for (std::size_t i = 0; i < count; ++i) reflectance[i] = static_cast<std::uint8_t>(facts[i] >> 16U);
  for (std::size_t i = 0; i < count; ++i) incidence[i] = static_cast<std::uint8_t>(facts[i] >> 24U);
}

/// Depth of a perspective frustum, 0 at `near` and 1 at `far`, where nothing is.
AMISS_WIDE void to_metres(float* depth, std::size_t count, float near, float far) {
  const float product = near * far, range = far - near;
  for (std::size_t i = 0; i < count; ++i) {
    const float d = depth[i];
    depth[i] = d < 1.0F ? product / (far - d * range) : std::numeric_limits<float>::quiet_NaN();
  }
}

}  // namespace

void FrameTargets::resize(const GlFunctions& gl, int width, int height) {
  if (width == width_ && height == height_) return;
  release(gl);
  gl.GenFramebuffers(1, &framebuffer_);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl.GenRenderbuffers(3, buffers_);
  constexpr GLenum kFormats[] = {GL_RGBA8, GL_R32UI, GL_DEPTH_COMPONENT32F};
  constexpr GLenum kPlaces[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_DEPTH_ATTACHMENT};
  for (int i = 0; i < 3; ++i) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, buffers_[i]);
    gl.RenderbufferStorage(GL_RENDERBUFFER, kFormats[i], width, height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, kPlaces[i], GL_RENDERBUFFER, buffers_[i]);
  }
  gl.DrawBuffers(2, kPlaces);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("OSMesa cannot make a frame buffer of the camera's size");
  width_ = width;
  height_ = height;
}

void FrameTargets::begin(const GlFunctions& gl, const Eigen::Vector3f& background) const {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl.Viewport(0, 0, width_, height_);
  const float colour[] = {background.x(), background.y(), background.z(), 1.0F};
  const GLuint nobody[] = {0, 0, 0, 0};
  const float far_away[] = {1.0F};
  gl.DepthMask(GL_TRUE);
  gl.ClearBufferfv(GL_COLOR, 0, colour);
  gl.ClearBufferuiv(GL_COLOR, 1, nobody);
  gl.ClearBufferfv(GL_DEPTH, 0, far_away);
}

void FrameTargets::read(const GlFunctions& gl, const RenderOptions& options, RenderedFrame& frame) {
  const std::size_t count = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  scratch_.resize(count + 3);
  frame.colour.resize(count);
  frame.instances.resize(count);
  frame.reflectance.resize(count);
  frame.incidence.resize(count);
  frame.depth_m.resize(count);
  gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
  gl.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, scratch_.data());
  drop_alpha(scratch_.data(), frame.colour.data(), count);
  gl.ReadBuffer(GL_COLOR_ATTACHMENT1);
  gl.ReadPixels(0, 0, width_, height_, GL_RED_INTEGER, GL_UNSIGNED_INT, scratch_.data());
  unpack(scratch_.data(), frame, count);
  gl.ReadPixels(0, 0, width_, height_, GL_DEPTH_COMPONENT, GL_FLOAT, frame.depth_m.data());
  to_metres(frame.depth_m.data(), count, static_cast<float>(options.near_m), static_cast<float>(options.far_m));
}

void FrameTargets::release(const GlFunctions& gl) {
  if (framebuffer_ == 0) return;
  gl.DeleteFramebuffers(1, &framebuffer_);
  gl.DeleteRenderbuffers(3, buffers_);
  framebuffer_ = 0;
  width_ = height_ = 0;
}

}  // namespace amiss::sim::internal
