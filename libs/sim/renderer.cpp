#include "sim/renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/result.hpp"
#include "sim/internal/draw_list.hpp"
#include "sim/internal/frame_targets.hpp"
#include "sim/internal/gl_context.hpp"
#include "sim/internal/gl_program.hpp"
#include "sim/internal/gpu_scene.hpp"

namespace amiss::sim {
namespace {

using internal::GlFunctions;
using internal::GlProgram;
using Poses = std::span<const Transform<amiss::World, Object>>;

constexpr std::size_t kLights = 2;         // as in the shader
constexpr float kLeastAmbient = 0.2F;      // a world without light would show nothing
constexpr std::size_t kMaxBodies = 65534;  // instances are 16 bits, 0 is nothing

void check(const CameraIntrinsics& c, const RenderOptions& options) {
  const bool good = c.width > 0 && c.height > 0 && c.width <= 4096 && c.height <= 4096 && c.fx > 0.0 && c.fy > 0.0 &&
                    std::isfinite(c.fx) && std::isfinite(c.fy) && std::isfinite(c.cx) && std::isfinite(c.cy);
  if (!good)
    throw ArgumentError("camera intrinsics: width and height must be 1 to 4096 and fx, fy positive, cx, cy finite");
  if (!(options.near_m > 0.0 && options.far_m > options.near_m))
    throw ArgumentError("camera range: 0 < near < far is needed");
}

std::size_t program_index(const internal::GpuBatch& batch) {
  return (batch.transparent ? 2U : 0U) + (batch.texture != 0 ? 1U : 0U);
}

}  // namespace

struct Renderer::State {
  internal::GlContext context;
  std::array<GlProgram, 4> programs;  // by program_index
  internal::GpuScene scene;
  internal::FrameTargets targets;
  Eigen::Vector3f background;

  explicit State(const world::World& world);
  ~State();
  void set_lights(const GlFunctions& gl, const world::World& world) const;
  void set_camera(const GlFunctions& gl, const CameraIntrinsics& c, const RenderOptions& options) const;
  void draw(const GlFunctions& gl, std::span<const internal::DrawCall> calls,
            std::span<const Eigen::Isometry3f> T_camera_bodies, std::span<const Eigen::Matrix3f> R_world_bodies) const;
};

Renderer::State::State(const world::World& world) : background(world.background) {
  const internal::GlScope scope(context);
  const GlFunctions& gl = scope.gl;
  const std::array<std::string, 4> defines = {"", "#define TEXTURED\n", "#define TRANSPARENT\n",
                                              "#define TEXTURED\n#define TRANSPARENT\n"};
  for (std::size_t i = 0; i < defines.size(); ++i) programs[i] = internal::make_program(gl, defines[i]);
  set_lights(gl, world);
  gl.Enable(GL_DEPTH_TEST);
  gl.CullFace(GL_BACK);
  gl.FrontFace(GL_CW);  // rows run downwards, so the picture that GL draws is mirrored
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  for (const world::Body& body : world.bodies) scene.add(gl, internal::body_mesh(body));
}

Renderer::State::~State() {
  const internal::GlScope scope(context);
  scene.release(scope.gl);
  targets.release(scope.gl);
  for (const GlProgram& program : programs) scope.gl.DeleteProgram(program.id);
}

void Renderer::State::set_lights(const GlFunctions& gl, const world::World& world) const {
  const Eigen::Vector3f ambient = world.ambient.cwiseMax(kLeastAmbient);
  std::vector<world::Light> lights = world.lights;
  if (lights.empty()) lights.emplace_back();
  lights.resize(kLights, world::Light{-Eigen::Vector3f::UnitZ(), Eigen::Vector3f::Zero()});
  std::array<float, 3 * kLights> directions{}, colours{};
  for (std::size_t i = 0; i < kLights; ++i) {
    Eigen::Vector3f::Map(&directions[3 * i]) = lights[i].direction.normalized();
    Eigen::Vector3f::Map(&colours[3 * i]) = lights[i].colour;
  }
  for (const GlProgram& program : programs) {
    gl.UseProgram(program.id);
    gl.Uniform3fv(program.ambient, 1, ambient.data());
    gl.Uniform3fv(program.light_direction, kLights, directions.data());
    gl.Uniform3fv(program.light_colour, kLights, colours.data());
    gl.Uniform1i(program.picture, 0);
  }
}

void Renderer::State::set_camera(const GlFunctions& gl, const CameraIntrinsics& c, const RenderOptions& options) const {
  // GL's pixel centres lie at 0.5; ours at integers.
  const double w = c.width, h = c.height, near = options.near_m, far = options.far_m;
  const Eigen::Vector4f lens =
      Eigen::Vector4d(2.0 * c.fx / w, 2.0 * c.fy / h, 2.0 * (c.cx + 0.5) / w - 1.0, 2.0 * (c.cy + 0.5) / h - 1.0)
          .cast<float>();
  const Eigen::Vector4f ray =
      Eigen::Vector4d(1.0 / c.fx, 1.0 / c.fy, -(c.cx + 0.5) / c.fx, -(c.cy + 0.5) / c.fy).cast<float>();
  for (const GlProgram& program : programs) {
    gl.UseProgram(program.id);
    gl.Uniform4fv(program.lens, 1, lens.data());
    gl.Uniform2f(program.depth_range, static_cast<float>((far + near) / (far - near)),
                 static_cast<float>(-2.0 * far * near / (far - near)));
    gl.Uniform4fv(program.ray, 1, ray.data());
  }
}

void Renderer::State::draw(const GlFunctions& gl, std::span<const internal::DrawCall> calls,
                           std::span<const Eigen::Isometry3f> T_camera_bodies,
                           std::span<const Eigen::Matrix3f> R_world_bodies) const {
  gl.ActiveTexture(GL_TEXTURE0);
  bool blending = false;
  for (const internal::DrawCall& call : calls) {
    const internal::GpuBatch& batch = *call.batch;
    if (batch.transparent && !blending) {  // they come last; the depth camera sees through them
      blending = true;
      gl.Enablei(GL_BLEND, 0);
      gl.DepthMask(GL_FALSE);
      gl.ColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    }
    const GlProgram& program = programs[program_index(batch)];
    gl.UseProgram(program.id);
    gl.UniformMatrix4fv(program.T_camera_body, 1, GL_FALSE, T_camera_bodies[call.body].matrix().data());
    gl.UniformMatrix3fv(program.R_world_body, 1, GL_FALSE, R_world_bodies[call.body].data());
    gl.Uniform1ui(program.instance, static_cast<GLuint>(call.body + 1));
    (batch.closed ? gl.Enable : gl.Disable)(GL_CULL_FACE);
    const float two_sided = batch.closed ? 0.0F : 1.0F;
    gl.Uniform1f(program.two_sided, two_sided);
    if (batch.texture != 0) gl.BindTexture(GL_TEXTURE_2D, batch.texture);
    gl.BindVertexArray(scene.bodies()[call.body].array);
    gl.DrawElements(GL_TRIANGLES, batch.index_count, GL_UNSIGNED_INT,
                    reinterpret_cast<const void*>(batch.offset_bytes));
  }
  if (!blending) return;
  gl.Disablei(GL_BLEND, 0);
  gl.DepthMask(GL_TRUE);
  gl.ColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

Renderer::Renderer(const world::World& world) {
  if (world.bodies.size() > kMaxBodies) throw ArgumentError("a world may hold at most 65534 bodies");
  state_ = std::make_unique<State>(world);
  // The first picture makes llvmpipe compile the shaders.
  (void)render({}, CameraIntrinsics{}, start_poses(world), {.cull = false});
}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

std::size_t Renderer::add_body(const world::Body& body) {
  if (body_count() >= kMaxBodies) throw ArgumentError("a world may hold at most 65534 bodies");
  const internal::GlScope scope(state_->context);
  state_->scene.add(scope.gl, internal::body_mesh(body));
  return body_count() - 1;
}

void Renderer::keep_bodies(std::size_t count) {
  const internal::GlScope scope(state_->context);
  state_->scene.keep(scope.gl, count);
}

std::size_t Renderer::body_count() const { return state_->scene.bodies().size(); }

RenderedFrame Renderer::render(const Transform<amiss::World, Camera>& T_world_camera,
                               const CameraIntrinsics& intrinsics, Poses poses, const RenderOptions& options) {
  check(intrinsics, options);
  if (poses.size() != body_count())
    throw ArgumentError("the renderer has " + std::to_string(body_count()) + " bodies but got " +
                        std::to_string(poses.size()) + " poses");
  std::vector<Eigen::Isometry3f> T_camera_bodies;
  std::vector<Eigen::Matrix3f> R_world_bodies;
  const Transform<Camera, amiss::World> T_camera_world = T_world_camera.inverse();
  for (const auto& pose : poses) {
    T_camera_bodies.push_back((T_camera_world * pose).T.cast<float>());
    R_world_bodies.emplace_back(pose.T.linear().cast<float>());
  }
  RenderedFrame frame;
  frame.intrinsics = intrinsics;
  const internal::GlScope scope(state_->context);
  state_->targets.resize(scope.gl, intrinsics.width, intrinsics.height);
  state_->targets.begin(scope.gl, state_->background);
  state_->set_camera(scope.gl, intrinsics, options);
  state_->draw(scope.gl, draw_list(state_->scene.bodies(), T_camera_bodies, intrinsics, options), T_camera_bodies,
               R_world_bodies);
  state_->targets.read(scope.gl, options, frame);
  return frame;
}

std::string opengl_version() {
  internal::GlContext context;
  const internal::GlScope scope(context);
  const auto text = [&](unsigned name) { return std::string(reinterpret_cast<const char*>(scope.gl.GetString(name))); };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

std::vector<Transform<amiss::World, Object>> start_poses(const world::World& world) {
  std::vector<Transform<amiss::World, Object>> poses;
  for (const world::Body& body : world.bodies) poses.push_back(body.pose);
  return poses;
}

Transform<amiss::World, Camera> look_at(const Point<amiss::World>& eye, const Point<amiss::World>& target) {
  const Eigen::Vector3d forward = (target.p - eye.p).normalized();
  const bool steep = std::abs(forward.z()) > 0.999;
  const Eigen::Vector3d up = steep ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d right = forward.cross(up).normalized();
  Transform<amiss::World, Camera> T_world_camera;
  T_world_camera.T.linear() << right, forward.cross(right), forward;
  T_world_camera.T.translation() = eye.p;
  return T_world_camera;
}

CameraIntrinsics pinhole(int width, int height, double horizontal_fov_rad) {
  const double f = width / 2.0 / std::tan(horizontal_fov_rad / 2.0);
  return {width, height, f, f, (width - 1) / 2.0, (height - 1) / 2.0};
}

}  // namespace amiss::sim
