// A simulated robot in a simulated world, behind the port that a real one would stand behind.
// World, model, parameters, seed -> Observations; a run is a function of these, with one thread or two.
// observe() lets 20 ms pass: the base accelerates towards the commanded velocity within its limits and stops at what
// cannot be pushed, the head turns at its speed, bodies move, odometry, laser and camera measure. A frame is rendered
// by the worker from a copy of all poses, and arrives `camera.delay` of simulated time later.
// truth(), collisions() and instances_of() are for referees and reports: no decision of the robot may rest on them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/params.hpp"
#include "core/worker.hpp"
#include "robot/model.hpp"
#include "robot/robot.hpp"
#include "sim/depth_noise.hpp"
#include "sim/laser.hpp"
#include "sim/odometry.hpp"
#include "sim/physics.hpp"
#include "sim/renderer.hpp"
#include "world/truth.hpp"
#include "world/world.hpp"

namespace amiss::sim {

struct SimulatorParams {
  PhysicsParams physics;
  LaserParams laser;
  OdometryParams odometry;
  DepthNoiseParams depth;
  double camera_period_s = 0.2;
  double camera_delay_s = 0.1;  // from the instant of a frame to its arrival
};
void describe(ParamTable& table, SimulatorParams& params);

class Simulator final : public robot::Robot {
 public:
  Simulator(world::World world, robot::Model model, const SimulatorParams& params, std::uint64_t seed,
            const Pose2<amiss::World, Base>& start, Worker& worker);
  ~Simulator() override;
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;

  [[nodiscard]] const robot::Model& model() const override;
  void command(const robot::Command& command) override;
  robot::Observation observe() override;

  /// All movable bodies of the world, those told of, then what was added; `kind` of the world's own bodies is empty.
  [[nodiscard]] world::Truth truth() const;
  [[nodiscard]] const std::vector<world::Collision>& collisions() const;
  /// The ids of one of the last 20 frames that were delivered, by the stamp of the frame; nullptr for all others.
  [[nodiscard]] const world::InstanceImage* instances_of(Stamp stamp) const;
  /// The world as it is now: bodies at their present poses, removed ones left out.
  [[nodiscard]] world::World world_now() const;
  [[nodiscard]] RenderedFrame picture(const Transform<amiss::World, Camera>& T_world_camera,
                                      const CameraIntrinsics& intrinsics);

  /// Scripted changes; the value that the object's pixels have in InstanceImages. ArgumentError when the name is taken
  /// or nobody's.
  std::uint16_t add_object(const world::Body& body, const Transform<amiss::World, Object>& pose,
                           const std::string& kind);
  void move_object(const std::string& name, const Transform<amiss::World, Object>& pose);
  void remove_object(const std::string& name);
  /// Lifts the robot and puts it down elsewhere; neither wheels nor bumpers feel it. ArgumentError where it has no room.
  void carry_robot(const Pose2<amiss::World, Base>& T_world_base);
  /// From now on truth() tells of this body of the world even if nothing can move it. ArgumentError for nobody's name.
  void tell_of(const std::string& name);

  /// CPU time of the calling thread or the worker's, by part, since the start; no decision and no report's digest may
  /// rest on it.
  struct CpuTime {
    double physics_s = 0.0, laser_s = 0.0, render_s = 0.0, noise_s = 0.0;
  };
  [[nodiscard]] CpuTime cpu_time() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace amiss::sim
