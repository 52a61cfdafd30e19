#include "training/sampler.hpp"

#include <cmath>

#include "mapping/surface_map.hpp"
#include "mapping/surface_mesh.hpp"
#include "semantics/class_votes.hpp"
#include "sim/depth_noise.hpp"
#include "sim/renderer.hpp"

namespace amiss::training {

namespace {

/// Where the robot believes that the camera is.
Transform<Map, Camera> believed(const Transform<World, Camera>& view, const SamplerParams& params,
                                RandomStream& random) {
  Eigen::Isometry3d error = Eigen::Isometry3d::Identity();
  const auto shift = [&] { return random.normal() * params.position_sigma_m; };
  const double x = shift(), y = shift(), z = shift() / 2;
  error.translate(view.position() + Eigen::Vector3d(x, y, z));
  error.rotate(Eigen::AngleAxisd(random.normal() * params.yaw_sigma_rad, Eigen::Vector3d::UnitZ()));
  error.translate(-view.position());
  return {error * view.T};
}

std::vector<SemanticClass> classes_of(const world::World& world, const world::ClassTable& table) {
  std::vector<SemanticClass> classes{SemanticClass::kUnlabelled};
  for (const world::Body& body : world.bodies) classes.push_back(table.class_of(body.name));
  return classes;
}

}  // namespace

LabelledCloud sampled_cloud(const world::World& world, const world::ClassTable& classes,
                            std::span<const Transform<World, Camera>> views, const SamplerParams& params,
                            RandomStream& random) {
  sim::Renderer renderer(world);
  const auto poses = sim::start_poses(world);
  const std::vector<SemanticClass> class_of = classes_of(world, classes);
  const sim::DepthNoise noise({}, params.camera);
  mapping::SurfaceParams surface;
  surface.voxel_m = params.voxel_m;
  surface.max_range_m = params.max_range_m;
  mapping::SurfaceMap map(surface);
  semantics::ClassVotes votes({.voxel_m = params.voxel_m, .max_range_m = params.max_range_m + 0.2, .stride_px = 1});
  std::vector<SemanticClass> pixels;
  for (const Transform<World, Camera>& view : views) {
    sim::RenderedFrame rendered = renderer.render(view, params.camera, poses);
    pixels.clear();
    for (const std::uint16_t instance : rendered.instances) pixels.push_back(class_of.at(instance));
    const RgbdFrame perfect{{}, params.camera, {}, rendered.depth_m};
    const RgbdFrame frame = noise.apply(std::move(rendered), {}, random);
    const Transform<Map, Camera> pose = believed(view, params, random);
    map.insert(frame, pose);
    votes.add(perfect, pixels, pose);
  }
  LabelledCloud sampled;
  sampled.cloud = mapping::surface_cloud(mapping::surface_mesh(map), params.voxel_m);
  for (const Eigen::Vector3f& p : sampled.cloud.points) sampled.classes.push_back(votes.at(p));
  return sampled;
}

std::vector<Transform<World, Camera>> views_around(const Pose2<World, Base>& stand, double eye_height_m) {
  std::vector<Transform<World, Camera>> views;
  for (const double tilt : {radians(-48.0), radians(-22.0)}) {
    for (const double pan : {radians(-50.0), 0.0, radians(50.0)}) {
      const double yaw = stand.yaw_rad + pan;
      const Point<World> eye{{stand.x_m + 0.1 * std::cos(yaw), stand.y_m + 0.1 * std::sin(yaw), eye_height_m}};
      const Eigen::Vector3d ray(std::cos(tilt) * std::cos(yaw), std::cos(tilt) * std::sin(yaw), std::sin(tilt));
      views.push_back(sim::look_at(eye, Point<World>{eye.p + ray}));
    }
  }
  return views;
}

}  // namespace amiss::training
