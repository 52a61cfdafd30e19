// Draws a world by OpenGL in software (OSMesa): bodies and their poses -> colour, metric depth, body ids and what the
// depth sensor's noise depends on, in one pass.
//
// in:  world::World, poses T_world_object (as many as bodies), T_world_camera (optical frame), CameraIntrinsics
// out: RenderedFrame, images row-major with row 0 on top, pixel (u, v) as in core/sensors.hpp
// Errors: std::runtime_error when no GL 3.3 context can be made; ArgumentError for impossible intrinsics or when the
// number of poses differs from the number of bodies.
//
// Textures: uv (0, 0) is the lower left corner of the picture, as in OBJ and COLLADA; they repeat.
// Threads: any thread may call, one at a time for one Renderer; several Renderers may draw at the same time. The first
// Renderer sets LP_NUM_THREADS=0 in the environment of the process (unless it is set), so that llvmpipe draws in the
// calling thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/frames.hpp"
#include "core/sensors.hpp"
#include "world/world.hpp"

namespace amiss::sim {

/// What the camera sees, without noise. All images hold width * height values.
struct RenderedFrame {
  CameraIntrinsics intrinsics;
  std::vector<Rgb> colour;                // sRGB
  std::vector<float> depth_m;             // along z of the camera; NaN where nothing (solid) is
  std::vector<std::uint16_t> instances;   // body index + 1; 0 is nothing
  std::vector<std::uint8_t> incidence;    // 255 * cosine of the angle between ray and surface normal
  std::vector<std::uint8_t> reflectance;  // 255 * share of the projector's light that the surface scatters back
};

struct RenderOptions {
  double near_m = 0.05, far_m = 30.0;        // along z of the camera
  std::span<const std::size_t> hidden = {};  // indices of bodies that are not drawn
  bool cull = true;                          // skip what lies outside of the frustum; the picture is the same without
};

class Renderer {
 public:
  explicit Renderer(const world::World& world);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// The index of the new body; its pose is the next one of `poses`.
  std::size_t add_body(const world::Body& body);
  /// Forget the bodies from this index on.
  void keep_bodies(std::size_t count);
  [[nodiscard]] std::size_t body_count() const;

  [[nodiscard]] RenderedFrame render(const Transform<amiss::World, Camera>& T_world_camera,
                                     const CameraIntrinsics& intrinsics,
                                     std::span<const Transform<amiss::World, Object>> poses,
                                     const RenderOptions& options = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Who draws: renderer and version as OpenGL tells them; std::runtime_error as above.
[[nodiscard]] std::string opengl_version();

/// Where every body starts, in the order of the world.
[[nodiscard]] std::vector<Transform<amiss::World, Object>> start_poses(const world::World& world);

/// An optical frame at `eye` that looks at `target`, upwards is +z of the world (or +y when looking straight down).
[[nodiscard]] Transform<amiss::World, Camera> look_at(const Point<amiss::World>& eye,
                                                      const Point<amiss::World>& target);

/// A pinhole camera with square pixels and the principal point in the middle.
[[nodiscard]] CameraIntrinsics pinhole(int width, int height, double horizontal_fov_rad);

}  // namespace amiss::sim
