#include "video/chase.hpp"

#include <cmath>

#include "sim/renderer.hpp"

namespace amiss::video {

namespace {

constexpr double kBehind_m = 2.3, kAbove_m = 3.1, kAhead_m = 0.5;  // of the robot: the camera, and where it looks
constexpr double kMoveTime_s = 0.25, kTurnTime_s = 1.2;            // of the film, to follow by 63 %

}  // namespace

std::size_t FilmTimes::count() const {
  return 1 + static_cast<std::size_t>(std::max(0.0, std::floor((end_s - begin_s) / speed * frames_per_s + 1e-9)));
}

double FilmTimes::at_s(std::size_t frame) const {
  return std::min(end_s, begin_s + static_cast<double>(frame) * speed / frames_per_s);
}

std::vector<Transform<World, Camera>> chase(const page::Story& story, const FilmTimes& times) {
  const double move = 1.0 - std::exp(-1.0 / (kMoveTime_s * times.frames_per_s));
  const double turn = 1.0 - std::exp(-1.0 / (kTurnTime_s * times.frames_per_s));
  Pose2<Map, Base> seen = page::pose_at(story, times.begin_s).truth;
  std::vector<Transform<World, Camera>> cameras;
  for (std::size_t i = 0; i < times.count(); ++i) {
    const Pose2<Map, Base> robot = page::pose_at(story, times.at_s(i)).truth;
    seen.x_m += move * (robot.x_m - seen.x_m);
    seen.y_m += move * (robot.y_m - seen.y_m);
    seen.yaw_rad = wrap_angle(seen.yaw_rad + turn * wrap_angle(robot.yaw_rad - seen.yaw_rad));
    const Transform<World, Base> T_world_seen = story.place.T_world_map * seen.lift();
    cameras.push_back(sim::look_at(T_world_seen * Point<Base>{{-kBehind_m, 0.0, kAbove_m}},
                                   T_world_seen * Point<Base>{{kAhead_m, 0.0, 0.2}}));
  }
  return cameras;
}

}  // namespace amiss::video
