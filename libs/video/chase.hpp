// The camera that follows the robot from behind and above: it turns and moves with it, softly. Story, speed and frames
// a second of the film -> T_world_camera of each frame. A function of these alone. World frame, metres.
#pragma once

#include <vector>

#include "page/story.hpp"

namespace amiss::video {

struct FilmTimes {
  double speed = 8.0;  // simulated seconds in a second of the film
  int frames_per_s = 25;
  double begin_s = 0.0, end_s = 0.0;  // simulated

  [[nodiscard]] std::size_t count() const;             // of frames, at least one
  [[nodiscard]] double at_s(std::size_t frame) const;  // simulated
};

[[nodiscard]] std::vector<Transform<World, Camera>> chase(const page::Story& story, const FilmTimes& times);

}  // namespace amiss::video
