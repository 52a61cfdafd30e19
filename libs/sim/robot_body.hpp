// The robot as a body among others: moved where it wants to go, it pushes what can move and stops at what cannot.
// Pose of the base in the world and poses of the links in the base -> pose that was reached, and what was touched.
// Ground does not count as touched: static shapes no higher than 1 cm, and faces of static shapes that the robot stands
// on.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robot/model.hpp"
#include "sim/physics.hpp"

namespace amiss::sim {

struct RobotState {
  Pose2<amiss::World, Base> T_world_base;
  std::vector<Eigen::Isometry3d> T_base_link;  // as Model::link_poses gives them
};

struct Touch {
  std::string link, body;
  Point<amiss::World> position;
};

struct RobotStep {
  Pose2<amiss::World, Base> T_world_base;
  bool blocked = false;        // a static body held it, in part or altogether
  std::vector<Touch> touches;  // sorted by body, one for each
};

class RobotBody {
 public:
  /// `physics` must live as long.
  RobotBody(Physics& physics, const robot::Model& model, const RobotState& start);
  ~RobotBody();
  RobotBody(RobotBody&&) noexcept;
  RobotBody& operator=(RobotBody&&) = delete;

  /// Moves towards `wanted` as far as static bodies allow (along them where it can) while `dt` passes for all bodies.
  [[nodiscard]] RobotStep move(const RobotState& wanted, Duration dt);
  /// Puts it there, whatever is on the way; then statics_changed() is to be told.
  void put(const RobotState& state);
  /// To be told when static bodies were added, placed or removed.
  void statics_changed();
  /// Would the robot, standing so, touch no static body other than the ground?
  [[nodiscard]] bool fits(const RobotState& state);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace amiss::sim
