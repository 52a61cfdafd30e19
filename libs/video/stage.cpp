#include "video/stage.hpp"

#include <set>

#include "video/section.hpp"
#include "world/mesh_file.hpp"

namespace amiss::video {

namespace {

void append(const robot::LinkShape& shape, std::vector<world::Shape>& out) {
  const Eigen::Vector3d& d = shape.dimensions;
  world::Material material;
  material.diffuse = shape.rgba.head<3>();
  material.alpha = shape.rgba.w();
  switch (shape.kind) {
    case robot::LinkShape::Kind::kBox:
      return out.push_back({world::Box{d}, shape.T_link_shape, material});
    case robot::LinkShape::Kind::kCylinder:
      return out.push_back({world::Cylinder{d.x(), d.y()}, shape.T_link_shape, material});
    case robot::LinkShape::Kind::kSphere:
      return out.push_back({world::Sphere{d.x()}, shape.T_link_shape, material});
    case robot::LinkShape::Kind::kMesh:
      break;
  }
  for (const world::MeshPart& part : world::load_mesh(shape.mesh).parts) {
    out.push_back({world::MeshInstance{part.mesh, d}, shape.T_link_shape, part.material});
  }
}

world::World opened(world::World world) {
  for (world::Body& body : world.bodies) {
    if (body.is_static) body = cut_open(std::move(body));
  }
  return world;
}

}  // namespace

std::vector<world::Body> link_bodies(const robot::Model& model) {
  std::vector<world::Body> bodies;
  for (const robot::Link& link : model.links) {
    world::Body& body = bodies.emplace_back();
    body.name = link.name;
    for (const robot::LinkShape& shape : link.visuals) append(shape, body.visuals);
  }
  return bodies;
}

Stage::Stage(world::World world, const std::map<std::string, world::Body>& kinds, const robot::Model& model,
             const page::Story& story)
    : story_(story), model_(model), renderer_(opened(world)), poses_(sim::start_poses(world)) {
  std::map<std::string, std::size_t> own;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) own[world.bodies[i].name] = i;
  for (const auto& [t, body] : story.bodies) {
    if (bodies_.contains(body.name) || !body.T_map_body) continue;
    const auto kind = kinds.find(body.kind);
    if (own.contains(body.name)) {
      bodies_[body.name] = own[body.name];
    } else if (kind != kinds.end()) {
      bodies_[body.name] = renderer_.add_body(kind->second);
    }
  }
  first_link_ = renderer_.body_count();
  for (const world::Body& link : link_bodies(model)) renderer_.add_body(link);
  poses_.resize(renderer_.body_count());
}

void Stage::set_the_scene(double t_s) {
  std::set<std::size_t> absent;
  for (const auto& [name, index] : bodies_) absent.insert(index);
  for (const auto& [t, body] : story_.bodies) {
    if (t > t_s) break;
    const auto found = bodies_.find(body.name);
    if (found == bodies_.end()) continue;
    if (body.T_map_body) {
      poses_[found->second] = story_.place.T_world_map * *body.T_map_body;
      absent.erase(found->second);
    } else {
      absent.insert(found->second);
    }
  }
  hidden_.assign(absent.begin(), absent.end());
  const page::StoryPose robot = pose_at(story_, t_s);
  const Eigen::Isometry3d T_world_base = (story_.place.T_world_map * robot.truth.lift()).T;
  const auto links =
      model_.link_poses({{model_.pan_joint, robot.head.pan_rad}, {model_.tilt_joint, robot.head.tilt_rad}});
  for (std::size_t i = 0; i < links.size(); ++i) poses_[first_link_ + i].T = T_world_base * links[i];
}

sim::RenderedFrame Stage::picture(double t_s, const Transform<World, Camera>& T_world_camera,
                                  const CameraIntrinsics& camera) {
  set_the_scene(t_s);
  return renderer_.render(T_world_camera, camera, poses_, {.hidden = hidden_});
}

}  // namespace amiss::video
