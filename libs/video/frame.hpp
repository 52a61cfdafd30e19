// A frame of a film about a run: the third-person view with marks on the floor, the robot's camera, the map with path,
// regions and objects so far, and a timeline with what happens. Story, instant, pictures -> 1280 x 720 pixels.
// Pixels row-major, row 0 on top. The same input gives the same pixels.
#pragma once

#include <string_view>
#include <vector>

#include "page/story.hpp"
#include "sim/renderer.hpp"

namespace amiss::video {

inline constexpr int kFrameWidth = 1280, kFrameHeight = 720;

/// How the third-person view is to be taken, to fit.
[[nodiscard]] CameraIntrinsics third_person_camera();

struct ThirdPerson {
  sim::RenderedFrame picture;  // of third_person_camera()
  Transform<World, Camera> T_world_camera;
};

/// `camera_jpeg`: what the robot saw last; empty before its first picture. InputError for bytes that are no picture.
[[nodiscard]] std::vector<Rgb> compose(const page::Story& story, double t_s, const ThirdPerson& view,
                                       std::string_view camera_jpeg);

}  // namespace amiss::video
