// A simulated robot in a world that changes by a script: carries out each event when its moment has come, then observes
// through sensors that may be broken. Simulator, script, bodies by kind, seed -> Observations.
// Events at time 0 happen before the first observation. What has been detected or examined is told by the app, which
// knows the truth; nothing of it reaches the robot but what its sensors say.
// Bodies that the script moves or takes away must be movable for the simulator: unfix() them first.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/sensor_faults.hpp"
#include "sim/simulator.hpp"
#include "world/script.hpp"

namespace amiss::sim {

/// What the script did.
struct Happening {
  Stamp stamp;
  std::string what;
};

class ScriptedRobot final : public robot::Robot {
 public:
  /// `bodies`: by kind, for what the script adds, with "person" for who walks. The simulator outlives this.
  /// ArgumentError where an event cannot be carried out: an unknown kind or name, no room for the robot.
  ScriptedRobot(Simulator& simulator, world::Script script, std::map<std::string, world::Body> bodies,
                std::uint64_t seed);

  [[nodiscard]] const robot::Model& model() const override { return simulator_.model(); }
  void command(const robot::Command& command) override { simulator_.command(command); }
  robot::Observation observe() override;

  /// The moment of events that wait for this.
  void detected(const std::string& object) { come(world::Moment::Kind::kDetected, object); }
  void examined(const std::string& object) { come(world::Moment::Kind::kExamined, object); }

  [[nodiscard]] const std::vector<Happening>& happened() const { return happened_; }
  /// Events whose moment never came, as text.
  [[nodiscard]] std::vector<std::string> not_happened() const;

 private:
  struct Pending {
    world::Event event;
    std::optional<Stamp> due;
    bool done = false;
  };
  struct Walker {
    world::Walk walk;
    std::size_t next = 1;  // of the way
    Pose2<amiss::World, Object> at;
  };

  void come(world::Moment::Kind kind, const std::string& object);
  void carry_out_what_is_due();
  void carry_out(const world::Change& change);
  void put(const std::string& name, const world::Body& body, const world::Place& place);
  void begin_walk(const world::Walk& walk);
  void let_walk();
  /// True when this one has arrived.
  bool step(Walker& walker);
  [[nodiscard]] const world::Body& body_of(const std::string& kind) const;
  [[nodiscard]] world::Body body_named(const std::string& name) const;

  Simulator& simulator_;
  std::vector<Pending> pending_;
  std::map<std::string, world::Body> bodies_;
  std::vector<Walker> walkers_;
  SensorFaults faults_;
  Stamp now_{};
  std::vector<Happening> happened_;
};

/// Takes the bodies that the script moves, takes away or closes out of the world; the simulator gets them back as added
/// objects, so that they can be changed. ArgumentError with the nearest name for a body that neither is there nor will
/// be.
[[nodiscard]] std::vector<world::Body> unfix(world::World& world, const world::Script& script);

/// The place as a pose at which the body stands, or hangs where the place says so.
[[nodiscard]] Transform<amiss::World, Object> pose_at(const world::Body& body, const world::Place& place);

}  // namespace amiss::sim
