#include "scenario_run.hpp"

#include <algorithm>

#include "core/result.hpp"
#include "interrupt.hpp"
#include "kinds.hpp"
#include "reference_cache.hpp"
#include "run_page.hpp"
#include "scenario_watch.hpp"
#include "start_pose.hpp"

namespace amiss::app {

namespace {

void apply(Settings& settings, const std::vector<scenario::Setting>& differing) {
  ParamTable table = settings.table();
  for (const scenario::Setting& s : differing) table.set(s.key, s.value, s.where);
}

PreparedReference reference_of(const world::World& world, const robot::Model& model, const Pose2<World, Base>& start,
                               const Resources& resources, Settings& settings, bool threaded) {
  mission::Sinks sinks;
  sinks.stop = interrupted;
  auto prepared = cached_reference({world, model, start, resources.robot}, settings, threaded, sinks, [] {});
  if (!prepared) throw std::runtime_error("the mapping run did not come to its end");
  return std::move(*prepared);
}

/// z = 0 of the robot's map lies a little above the floor.
Transform<World, Map> lifted(const PreparedReference& prepared, const Settings& settings) {
  Transform<World, Map> T_world_map = prepared.T_world_map.lift();
  T_world_map.T.translate(Eigen::Vector3d(0.0, 0.0, settings.mission.perception.floor_clearance_m));
  return T_world_map;
}

page::Beginning beginning_of(const scenario::Scenario& scenario, const PreparedReference& prepared,
                             const robot::Model& model, const score::RefereeParams& referee,
                             const Transform<World, Map>& T_world_map) {
  return {AMISS_VERSION,
          scenario.name,
          "dynamic",
          scenario.seed,
          &prepared.reference.floor,
          &prepared.reference.mapped,
          &model,
          referee.max_error_m,
          referee.min_cover,
          referee.min_purity,
          {scenario.world, "", T_world_map}};
}

}  // namespace

bool ScenarioOutcome::as_expected() const {
  return std::all_of(findings.begin(), findings.end(), [](const score::Finding& f) { return f.holds; });
}

scenario::Vocabulary vocabulary_of(const Resources& resources) {
  scenario::Vocabulary words{models_in(resources.objects), models_in(resources.worlds / "models")};
  const std::vector<std::string> own = models_in(resources.scenarios / "models");
  words.furniture.insert(words.furniture.end(), own.begin(), own.end());
  return words;
}

ScenarioOutcome run_scenario(const scenario::Scenario& scenario, bool threaded, const ScenarioShow* show) {
  const Resources resources = find_resources();
  Settings settings = load_settings("", {});
  apply(settings, scenario.reference_params);
  world::World world = world::load_world(find_world(resources, scenario.world), settings.world);
  const robot::Model model = robot::load_model(resources.robot);
  const Pose2<World, Base> home = start_pose(world, model, {});
  const PreparedReference prepared = reference_of(world, model, home, resources, settings, threaded);

  apply(settings, scenario.params);
  settings.mission.perception.time_limit_s = scenario.time_limit_s;
  if (show != nullptr) show->folder.save("params.yaml", settings.table().to_yaml());
  const std::vector<std::string> kinds = scenario::kinds_of(scenario.script);
  auto bodies = load_kinds(resources, {kinds.begin(), kinds.end()}, settings.world);
  const std::vector<world::Body> movable = sim::unfix(world, scenario.script);
  Worker worker(threaded);
  sim::Simulator simulator(world, model, settings.simulator, scenario.seed, scenario.start.value_or(home), worker);
  for (const world::Body& body : movable) simulator.add_object(body, body.pose, body.name);
  sim::ScriptedRobot robot(simulator, scenario.script, std::move(bodies), scenario.seed);

  score::Referee referee({}, lifted(prepared, settings), settings.referee);
  knowledge::KnowledgeBase knowledge(settings.mission.knowledge);
  const plan::Domain domain = plan::load_domain(resources.pddl / "search.pddl");
  ScenarioWatch watch(scenario, simulator, robot, referee, knowledge, prepared.T_world_map);
  mission::Sinks sinks = watch.sinks();
  if (show != nullptr) show->page.attach(sinks);
  mission::Search search(robot, prepared.reference, knowledge, domain, settings.mission, scenario.seed,
                         scenario.until_found, sinks);
  if (show != nullptr) {
    show->page.begin(beginning_of(scenario, prepared, model, settings.referee, lifted(prepared, settings)),
                     {simulator, referee, lifted(prepared, settings), knowledge, &robot},
                     [&]() -> const mapping::VoxelMap& { return search.voxels(); });
  }
  const mission::SearchReport result = search.run();
  if (show != nullptr) show->page.settle();

  ScenarioOutcome outcome;
  outcome.record = watch.record(result);
  outcome.findings = score::judge(scenario.expect, outcome.record);
  outcome.simulated_s = seconds(result.ended);
  outcome.log = watch.log();
  outcome.picture_png = report::to_png(watch.floor_plan(prepared.reference.floor, search.seen_floor()));
  return outcome;
}

}  // namespace amiss::app
