// CPU time of the simulator for one simulated second, by part: sim_bench [world] [simulated seconds].
#include <cstdio>
#include <cstdlib>
#include <string>

#include "sim/free_space.hpp"
#include "sim/simulator.hpp"
#include "world/loader.hpp"

int main(int argc, char** argv) {
  using namespace amiss;
  const std::string root = AMISS_SOURCE_DIR;
  const std::string name = argc > 1 ? argv[1] : "flat_90";
  const double simulated_s = argc > 2 ? std::atof(argv[2]) : 60.0;
  world::World world = world::load_world(root + "/sim_worlds/" + name + ".sdf");
  const robot::Model model = robot::load_model(root + "/robot_model/hsr.urdf");
  const Pose2<World, Base> start = world.robot_start ? *world.robot_start : sim::free_start(world, model);
  const std::size_t bodies = world.bodies.size();
  Worker worker(false);
  sim::Simulator simulator(std::move(world), model, {}, 1, start, worker);
  for (int i = 0; i < static_cast<int>(50 * simulated_s); ++i) {
    // Back and forth with turns, so that it drives past furniture and stands before walls.
    const bool forth = (i / 200) % 2 == 0;
    simulator.command({{forth ? 0.3 : -0.3, 0.0}, (i / 400) % 2 == 0 ? 0.2 : -0.1, 0.0, -0.55});
    (void)simulator.observe();
  }
  const auto cpu = simulator.cpu_time();
  std::printf("%s, %zu bodies, ms of CPU for a simulated second: physics %.2f, laser %.2f, render %.2f, noise %.2f\n",
              name.c_str(), bodies, 1e3 * cpu.physics_s / simulated_s, 1e3 * cpu.laser_s / simulated_s,
              1e3 * cpu.render_s / simulated_s, 1e3 * cpu.noise_s / simulated_s);
  std::printf("laser %.3f ms a scan, render %.2f ms a frame, noise %.2f ms a frame, %zu collisions\n",
              1e3 * cpu.laser_s / simulated_s / 10.0, 1e3 * cpu.render_s / simulated_s / 5.0,
              1e3 * cpu.noise_s / simulated_s / 5.0, simulator.collisions().size());
}
