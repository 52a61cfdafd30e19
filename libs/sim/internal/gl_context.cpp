#include "sim/internal/gl_context.hpp"

#include <GL/osmesa.h>

#include <cstdlib>
#include <mutex>
#include <stdexcept>
#include <string>

namespace amiss::sim::internal {
namespace {

std::mutex& creation_mutex() {  // OSMesa makes a screen that all contexts share
  static std::mutex mutex;
  return mutex;
}

void draw_in_the_calling_thread() {
  static std::once_flag once;
  std::call_once(once, [] { setenv("LP_NUM_THREADS", "0", 0); });
}

template <class Function>
void load(Function& function, const char* name) {
  function = reinterpret_cast<Function>(OSMesaGetProcAddress(name));
  if (function == nullptr) throw std::runtime_error(std::string("OSMesa does not know ") + name + ", GL 3.3 is needed");
}

}  // namespace

GlContext::GlContext() {
  draw_in_the_calling_thread();
  const std::scoped_lock lock(creation_mutex());
  const int wanted[] = {OSMESA_FORMAT,
                        OSMESA_RGBA,
                        OSMESA_PROFILE,
                        OSMESA_CORE_PROFILE,
                        OSMESA_DEPTH_BITS,
                        0,
                        OSMESA_CONTEXT_MAJOR_VERSION,
                        3,
                        OSMESA_CONTEXT_MINOR_VERSION,
                        3,
                        0,
                        0};
  context_ = OSMesaCreateContextAttribs(wanted, nullptr);
  if (context_ == nullptr) throw std::runtime_error("OSMesa cannot make a context with OpenGL 3.3 core");
#define AMISS_GL_LOAD(type, name) load(functions_.name, "gl" #name);
  AMISS_GL_FUNCTIONS(AMISS_GL_LOAD)
#undef AMISS_GL_LOAD
}

GlContext::~GlContext() {
  const std::scoped_lock lock(creation_mutex());
  OSMesaDestroyContext(static_cast<OSMesaContext>(context_));
}

GlScope::GlScope(GlContext& context) : gl(context.functions_) {
  if (OSMesaMakeCurrent(static_cast<OSMesaContext>(context.context_), context.pixels_.data(), GL_UNSIGNED_BYTE, 8, 8) ==
      GL_FALSE)
    throw std::runtime_error("OSMesa cannot make its context current");
}

GlScope::~GlScope() { OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }

}  // namespace amiss::sim::internal
