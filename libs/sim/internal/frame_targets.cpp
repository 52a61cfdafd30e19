#include "sim/internal/frame_targets.hpp"

#include <limits>
#include <stdexcept>

namespace amiss::sim::internal {

void FrameTargets::resize(const GlFunctions& gl, int width, int height) {
  if (width == width_ && height == height_) return;
  release(gl);
  gl.GenFramebuffers(1, &framebuffer_);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl.GenRenderbuffers(4, buffers_);
  constexpr GLenum kFormats[] = {GL_RGBA8, GL_R32F, GL_R32UI, GL_DEPTH_COMPONENT24};
  constexpr GLenum kPlaces[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2, GL_DEPTH_ATTACHMENT};
  for (int i = 0; i < 4; ++i) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, buffers_[i]);
    gl.RenderbufferStorage(GL_RENDERBUFFER, kFormats[i], width, height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, kPlaces[i], GL_RENDERBUFFER, buffers_[i]);
  }
  gl.DrawBuffers(3, kPlaces);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("OSMesa cannot make a frame buffer of the camera's size");
  width_ = width;
  height_ = height;
}

void FrameTargets::begin(const GlFunctions& gl, const Eigen::Vector3f& background) const {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl.Viewport(0, 0, width_, height_);
  const float colour[] = {background.x(), background.y(), background.z(), 1.0F};
  const float nothing[] = {std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F, 0.0F};
  const GLuint nobody[] = {0, 0, 0, 0};
  const float far_away[] = {1.0F};
  gl.DepthMask(GL_TRUE);
  gl.ClearBufferfv(GL_COLOR, 0, colour);
  gl.ClearBufferfv(GL_COLOR, 1, nothing);
  gl.ClearBufferuiv(GL_COLOR, 2, nobody);
  gl.ClearBufferfv(GL_DEPTH, 0, far_away);
}

void FrameTargets::read(const GlFunctions& gl, RenderedFrame& frame) {
  const std::size_t count = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  scratch_.resize(count);
  gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
  gl.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, scratch_.data());
  frame.colour.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t rgba = scratch_[i];
    frame.colour[i] = {static_cast<std::uint8_t>(rgba), static_cast<std::uint8_t>(rgba >> 8U),
                       static_cast<std::uint8_t>(rgba >> 16U)};
  }
  gl.ReadBuffer(GL_COLOR_ATTACHMENT2);
  gl.ReadPixels(0, 0, width_, height_, GL_RED_INTEGER, GL_UNSIGNED_INT, scratch_.data());
  frame.instances.resize(count);
  frame.reflectance.resize(count);
  frame.incidence.resize(count);
  for (std::size_t i = 0; i < count; ++i) frame.instances[i] = static_cast<std::uint16_t>(scratch_[i]);
  for (std::size_t i = 0; i < count; ++i) frame.reflectance[i] = static_cast<std::uint8_t>(scratch_[i] >> 16U);
  for (std::size_t i = 0; i < count; ++i) frame.incidence[i] = static_cast<std::uint8_t>(scratch_[i] >> 24U);
  frame.depth_m.resize(count);
  gl.ReadBuffer(GL_COLOR_ATTACHMENT1);
  gl.ReadPixels(0, 0, width_, height_, GL_RED, GL_FLOAT, frame.depth_m.data());
}

void FrameTargets::release(const GlFunctions& gl) {
  if (framebuffer_ == 0) return;
  gl.DeleteFramebuffers(1, &framebuffer_);
  gl.DeleteRenderbuffers(4, buffers_);
  framebuffer_ = 0;
  width_ = height_ = 0;
}

}  // namespace amiss::sim::internal
