#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "core/result.hpp"
#include "interrupt.hpp"
#include "progress_line.hpp"
#include "reference_cache.hpp"
#include "report/floor_plan.hpp"
#include "report/run_folder.hpp"
#include "resources.hpp"
#include "start_pose.hpp"

namespace amiss::app {

namespace {

struct MapArguments {
  std::string world, out, params_file, robot;
  std::vector<std::string> overrides, model_paths;
  std::vector<double> start;
  std::uint64_t seed = 1;
  bool quiet = false;
};

std::string report_json(const std::string& world, std::uint64_t seed, const MappingOutcome& o, bool complete) {
  const nlohmann::ordered_json json = {
      {"schema", 1},
      {"version", AMISS_VERSION},
      {"world", world},
      {"seed", seed},
      {"outcome", complete ? "mapped" : "interrupted"},
      {"frontiers", o.report.frontiers},
      {"view_triangles", o.report.triangles},
      {"coverage", o.report.coverage},
      {"collisions", o.collisions},
      {"distance_m", o.report.distance_m},
      {"simulated_s", seconds(o.report.ended)},
      {"localization", {{"rmse_m", o.error.rmse_m}, {"rmse_rad", o.error.rmse_rad}, {"max_m", o.error.max_m}}}};
  return json.dump(2) + "\n";
}

int run(const MapArguments& a) {
  catch_interrupts();
  const Resources resources = find_resources();
  Settings settings = load_settings(a.params_file, a.overrides);
  world::LoadOptions load = settings.world;
  for (const std::string& path : a.model_paths) load.model_paths.emplace_back(path);
  const world::World world = world::load_world(find_world(resources, a.world), load);
  const std::filesystem::path robot_file = a.robot.empty() ? resources.robot : std::filesystem::path(a.robot);
  const robot::Model model = robot::load_model(robot_file);
  const Pose2<World, Base> start = start_pose(world, model, a.start);
  const std::string name = world.file.stem().string();
  const report::RunFolder folder(a.out.empty() ? report::unused_folder("runs", "map-" + name)
                                               : std::filesystem::path(a.out));
  folder.save("params.yaml", settings.table().to_yaml());

  ProgressLine progress(!a.quiet);
  mission::Sinks sinks;
  sinks.stop = interrupted;
  sinks.progress = [&](const mission::ProgressEvent& event) { progress.show(event, "mapping"); };
  std::string log;
  sinks.log = [&log](Stamp stamp, const std::string& what) {
    log += fmt::format("{:9.2f} s  {}\n", seconds(stamp), what);
  };
  const MappingOutcome outcome = run_mapping({world, model, start, robot_file, a.seed}, settings, true, sinks);
  progress.clear();

  folder.save("log.txt", log);
  const std::string json = report_json(name, a.seed, outcome, outcome.report.complete);
  if (!outcome.report.complete) {
    folder.interrupt(json);
    return interrupted() ? kInterrupted : kGoalNotMet;
  }
  save_prepared(folder.path(), outcome.report.reference, outcome.T_world_map);
  report::FloorPlan plan;
  plan.grid = outcome.report.reference.floor;
  folder.save("map.png", report::to_png(plan));
  folder.finish(json);
  if (!a.quiet) {
    std::cout << fmt::format(
        "{}: {:.1f} % of the floor seen, {:.0f} m driven in {:.0f} s (simulated)\nrun folder: {}\n", name,
        100.0 * outcome.report.coverage, outcome.report.distance_m, seconds(outcome.report.ended),
        folder.path().string());
  }
  return kGoalMet;
}

}  // namespace

void add_map_command(CLI::App& app, int& exit_status) {
  const auto a = std::make_shared<MapArguments>();
  CLI::App* map = app.add_subcommand("map", "the one-time mapping run that makes the reference of a world");
  map->add_option("--world", a->world, "name (see `amiss worlds`) or SDF file")->type_name("WORLD")->required();
  map->add_option("--seed", a->seed, "of everything random")->check(CLI::NonNegativeNumber)->capture_default_str();
  map->add_option("--out", a->out, "run folder [runs/map-WORLD]")->type_name("DIR");
  map->add_option("--params", a->params_file, "YAML file of parameters")->type_name("FILE");
  map->add_option("--set", a->overrides, "key=value, overrides a parameter; may be repeated")->type_name("KEY=VALUE");
  map->add_option("--robot", a->robot, "URDF file of another robot")->type_name("FILE");
  map->add_option("--model-path", a->model_paths, "folder searched for model:// names; may be repeated")
      ->type_name("DIR");
  map->add_option("--start", a->start, "where the robot begins: X,Y,HEADING of the world in m and degrees")
      ->delimiter(',')
      ->expected(3)
      ->check(CLI::Range(-1e4, 1e4));
  map->add_flag("--quiet", a->quiet, "no progress, no summary");
  map->callback([a, &exit_status] { exit_status = run(*a); });
}

}  // namespace amiss::app
