// The place of a run with the robot and all that lies about as they were at an instant, seen by a camera anywhere.
// World, models of what was brought in by kind, robot, Story -> pictures (colour and depth), by OpenGL in software.
// World frame, metres. Static bodies are cut open (see section.hpp). What the world has and the story moves (a door, a
// chair) is shown where the story says; what is of no known kind and not of the world is left out.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "page/story.hpp"
#include "sim/renderer.hpp"
#include "world/world.hpp"

namespace amiss::video {

class Stage {
 public:
  /// `story` outlives the stage.
  Stage(world::World world, const std::map<std::string, world::Body>& kinds, const robot::Model& model,
        const page::Story& story);

  [[nodiscard]] sim::RenderedFrame picture(double t_s, const Transform<World, Camera>& T_world_camera,
                                           const CameraIntrinsics& camera);

 private:
  void set_the_scene(double t_s);

  const page::Story& story_;
  robot::Model model_;
  sim::Renderer renderer_;
  std::map<std::string, std::size_t> bodies_;  // index of what can move, by name
  std::size_t first_link_ = 0;
  std::vector<Transform<World, Object>> poses_;
  std::vector<std::size_t> hidden_;
};

/// The links of a robot with what one sees of them, one body a link.
[[nodiscard]] std::vector<world::Body> link_bodies(const robot::Model& model);

}  // namespace amiss::video
