// An OSMesa context with a GL 3.3 core profile. It may be used from any thread, from one at a time: a GlScope makes it
// current and lets go of it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "sim/internal/gl_functions.hpp"

namespace amiss::sim::internal {

class GlContext {
 public:
  GlContext();  // std::runtime_error when OSMesa cannot give GL 3.3
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

 private:
  friend class GlScope;
  void* context_ = nullptr;                       // OSMesaContext
  std::array<std::uint8_t, 4 * 8 * 8> pixels_{};  // its own frame buffer, which nothing is drawn to
  GlFunctions functions_;
};

/// While it lives the context is current in this thread.
class GlScope {
 public:
  explicit GlScope(GlContext& context);
  ~GlScope();
  GlScope(const GlScope&) = delete;
  GlScope& operator=(const GlScope&) = delete;

  const GlFunctions& gl;
};

}  // namespace amiss::sim::internal
