#include "tidy_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <set>

#include "commands.hpp"
#include "core/files.hpp"
#include "interrupt.hpp"
#include "mapping/voxel_files.hpp"
#include "mission/search.hpp"
#include "mission/static_search.hpp"
#include "progress_line.hpp"
#include "reference_cache.hpp"
#include "report/run_folder.hpp"
#include "report/search_times.hpp"
#include "resources.hpp"
#include "run_page.hpp"
#include "start_pose.hpp"
#include "tidy_observer.hpp"
#include "tidy_recording.hpp"
#include "world/catalogue.hpp"

namespace amiss::app {

namespace {

double wall_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void tell_warnings(const world::World& world, bool quiet) {
  constexpr std::size_t kShown = 3;
  if (quiet) return;
  for (std::size_t i = 0; i < std::min(kShown, world.warnings.size()); ++i) {
    std::cerr << "amiss: warning: " << world.warnings[i] << "\n";
  }
  if (world.warnings.size() > kShown) {
    std::cerr << "amiss: " << world.warnings.size() - kShown << " more warnings about " << world.file.string() << "\n";
  }
}

/// Everything that a run starts from.
struct Scene {
  Resources resources = find_resources();
  world::World reference_world, world;
  robot::Model model;
  Pose2<World, Base> start;
};

Scene load_scene(const TidyOptions& options, const Settings& settings) {
  Scene scene;
  world::LoadOptions load = settings.world;
  for (const std::string& path : options.model_paths) load.model_paths.emplace_back(path);
  scene.world = world::load_world(find_world(scene.resources, options.world), load);
  tell_warnings(scene.world, options.quiet);
  scene.reference_world = options.reference_world.empty()
                              ? scene.world
                              : world::load_world(find_world(scene.resources, options.reference_world), load);
  if (!options.robot.empty()) scene.resources.robot = options.robot;
  scene.model = robot::load_model(scene.resources.robot);
  scene.start = start_pose(scene.reference_world, scene.model, options.start);
  return scene;
}

std::vector<sim::ScatteredObject> choose_objects(const TidyOptions& options, const Settings& settings,
                                                 const Scene& scene, const world::Catalogue& catalogue) {
  if (!options.scatter_file.empty()) return sim::load_scatter(options.scatter_file, catalogue);
  const int count = options.objects.value_or(options.reference_world.empty() ? 5 : 0);
  if (count == 0) return {};
  return sim::scatter(count, catalogue, scene.world, scene.model, scene.start,
                      RandomStream(options.scatter_seed.value_or(options.seed), "scatter"), settings.scatter);
}

/// Bodies of today's world that the reference world does not have, whether anything can move them or not.
std::set<std::string> new_bodies(const Scene& scene) {
  std::set<std::string> known, found;
  for (const world::Body& body : scene.reference_world.bodies) known.insert(body.name);
  for (const world::Body& body : scene.world.bodies) {
    if (!known.contains(body.name)) found.insert(body.name);
  }
  return found;
}

/// What is to be found: what was scattered, and what is new.
std::vector<world::ObjectTruth> placed_objects(const Scene& scene, const std::vector<sim::ScatteredObject>& scattered,
                                               const world::Truth& truth) {
  std::set<std::string> wanted = new_bodies(scene);
  for (const sim::ScatteredObject& object : scattered) wanted.insert(object.name);
  std::vector<world::ObjectTruth> placed;
  std::copy_if(truth.objects.begin(), truth.objects.end(), std::back_inserter(placed),
               [&](const world::ObjectTruth& o) { return wanted.contains(o.name); });
  return placed;
}

std::string outcome_of(const mission::SearchReport& search, const TidyOptions& options, const score::Referee& referee) {
  if (interrupted()) return "interrupted";
  if (options.until_found && referee.all_found()) return "found";
  return std::string(mission::to_string(search.end));
}

int exit_status_of(const std::string& outcome, const TidyOptions& options) {
  if (outcome == "interrupted") return kInterrupted;
  return outcome == (options.until_found ? "found" : "explored") ? kGoalMet : kGoalNotMet;
}

/// Wall time without what is not part of the search.
class Stopwatch {
 public:
  [[nodiscard]] double seconds_s() const { return wall_s() - begin_s_; }
  void leave_out(double seconds_s) { begin_s_ += seconds_s; }

 private:
  double begin_s_ = wall_s();
};

std::optional<PreparedReference> prepare_reference(const TidyOptions& options, Settings& settings, const Scene& scene,
                                                   ProgressLine& progress, Stopwatch& watch) {
  mission::Sinks sinks;
  sinks.stop = interrupted;
  sinks.progress = [&](const mission::ProgressEvent& event) { progress.show(event, "mapping"); };
  const MappingInput input{scene.reference_world, scene.model, scene.start, scene.resources.robot};
  const double before = watch.seconds_s();
  auto prepared = cached_reference(input, settings, options.threads > 1, sinks, [&] {
    if (!options.quiet) std::cerr << "amiss: mapping " << scene.reference_world.file.stem().string() << " once\n";
  });
  watch.leave_out(watch.seconds_s() - before);
  progress.clear();
  return prepared;
}

std::unique_ptr<sim::Simulator> make_simulator(const TidyOptions& options, const Settings& settings, const Scene& scene,
                                               const world::Catalogue& catalogue,
                                               const std::vector<sim::ScatteredObject>& scattered, Worker& worker) {
  auto simulator =
      std::make_unique<sim::Simulator>(scene.world, scene.model, settings.simulator, options.seed, scene.start, worker);
  for (const std::string& name : new_bodies(scene)) simulator->tell_of(name);
  for (const sim::ScatteredObject& object : scattered) {
    world::Body body = catalogue.at(object.kind).body;
    body.name = object.name;
    simulator->add_object(body, object.pose, object.kind);
  }
  return simulator;
}

/// z = 0 of the robot's map lies a little above the floor.
Transform<World, Map> lifted(const Pose2<World, Map>& T_world_map, const Settings& settings) {
  Transform<World, Map> lifted = T_world_map.lift();
  lifted.T.translate(Eigen::Vector3d(0.0, 0.0, settings.mission.perception.floor_clearance_m));
  return lifted;
}

score::Referee make_referee(const TidyOptions& options, const Settings& settings, const Scene& scene,
                            const std::vector<sim::ScatteredObject>& scattered, const world::Truth& truth,
                            const Pose2<World, Map>& T_world_map) {
  score::Referee referee(placed_objects(scene, scattered, truth), lifted(T_world_map, settings), settings.referee);
  if (options.until_found && referee.verdicts().empty()) {
    throw ArgumentError("--until found: there is nothing to be found; place objects or use --until explored");
  }
  return referee;
}

void finish(const report::RunFolder& folder, const TidyOptions& options, TidyOutcome& outcome,
            std::string_view artefacts) {
  outcome.json = report::to_json(outcome.report, artefacts);
  outcome.page->end(outcome.json);
  outcome.exit_status = exit_status_of(outcome.report.outcome, options);
  if (outcome.report.outcome == "interrupted") {
    folder.interrupt(outcome.json);
  } else {
    folder.finish(outcome.json);
  }
}

/// What a search needs beside its parameters.
struct Stage {
  const Scene& scene;
  const PreparedReference& prepared;
  sim::Simulator& simulator;
  score::Referee& referee;
  const report::RunFolder& folder;
  RunPage& page;
  TidyRecording& recording;
};

/// A world of amiss by its name, so that a run folder can be carried elsewhere.
page::Place place_of(const TidyOptions& options, const Settings& settings, const Scene& scene,
                     const PreparedReference& prepared) {
  const std::filesystem::path& file = scene.world.file;
  const bool own = file.parent_path() == scene.resources.worlds;
  return {own ? file.stem().string() : file.string(),
          options.robot.empty() ? "" : std::filesystem::absolute(options.robot).string(),
          lifted(prepared.T_world_map, settings)};
}

std::unique_ptr<mission::SearchMethod> make_search(const TidyOptions& options, const Settings& settings,
                                                   const Stage& stage, const plan::Domain& domain,
                                                   knowledge::KnowledgeBase& knowledge, const mission::Sinks& sinks) {
  const auto make = [&]<class Method>(std::type_identity<Method>) -> std::unique_ptr<mission::SearchMethod> {
    return std::make_unique<Method>(stage.recording.robot(), stage.prepared.reference, knowledge, domain,
                                    settings.mission, options.seed, options.until_found, sinks);
  };
  if (options.method == report::kStatic) return make(std::type_identity<mission::StaticSearch>());
  return make(std::type_identity<mission::Search>());
}

/// The search itself, and the run folder's contents. Returns the artefacts that the digest covers.
std::string search(const TidyOptions& options, const Settings& settings, const Stage& stage, ProgressLine& progress,
                   report::TidyReport& report) {
  const auto& [scene, prepared, simulator, referee, folder, page, recording] = stage;
  TidyObserver observer(simulator, referee, folder, progress,
                        [&](Stamp stamp, const std::string& what) { recording.log(stamp, what); });
  mission::Sinks sinks = observer.sinks(options.until_found);
  page.attach(sinks);
  const std::filesystem::path domain_file = scene.resources.pddl / "search.pddl";
  const plan::Domain domain = plan::load_domain(domain_file);
  folder.save("plans/domain.pddl", load_bytes(domain_file));
  knowledge::KnowledgeBase knowledge(folder.path() / "knowledge.sqlite", settings.mission.knowledge);
  const auto search = make_search(options, settings, stage, domain, knowledge, sinks);
  const auto voxels = [&]() -> const mapping::VoxelMap& { return search->voxels(); };
  page.begin({report.version, report.world, report.method, report.seed, &prepared.reference.floor,
              &prepared.reference.mapped, &scene.model, settings.referee.max_error_m, settings.referee.min_cover,
              settings.referee.min_purity, place_of(options, settings, scene, prepared)},
             {simulator, referee, lifted(prepared.T_world_map, settings), knowledge}, voxels);
  recording.attach(sinks, knowledge, voxels);
  const mission::SearchReport result = search->run();
  page.settle();
  recording.close();
  knowledge.close();
  progress.clear();

  report.outcome = outcome_of(result, options, referee);
  observer.fill(report, result, knowledge.now(), prepared.T_world_map);
  const std::string map_bytes = mapping::voxel_map_bytes(search->voxels(), mapping::VoxelFormat::kOt);
  folder.save("current.ot", map_bytes);
  folder.save("map.png", observer.floor_plan(prepared.reference.floor, search->seen_floor(), knowledge.now(),
                                             prepared.T_world_map));
  folder.save("log.txt", observer.log());
  return map_bytes + observer.save_trajectories();
}

}  // namespace

TidyOutcome run_tidy(const TidyOptions& options, Settings settings) {
  catch_interrupts();
  // llvmpipe draws the same picture with threads of its own; they use the core that waits for a frame.
  if (options.threads > 1) setenv("LP_NUM_THREADS", "2", 0);
  Stopwatch watch;
  const Scene scene = load_scene(options, settings);
  const world::Catalogue catalogue = world::load_catalogue({scene.resources.objects}, settings.world);
  const auto scattered = choose_objects(options, settings, scene, catalogue);
  const std::string name = scene.world.file.stem().string();
  const report::RunFolder folder(
      options.out.empty() ? report::unused_folder("runs", "tidy-" + name + "-" + std::to_string(options.seed))
                          : std::filesystem::path(options.out));
  folder.save("params.yaml", settings.table().to_yaml());
  settings.mission.perception.time_limit_s = options.time_limit_s;
  settings.mission.perception.threaded = options.threads > 1;

  TidyOutcome outcome;
  outcome.page = std::make_shared<RunPage>(folder, options.view, options.threads > 1);
  outcome.folder = folder.path().string();
  outcome.report.version = AMISS_VERSION;
  outcome.report.world = name;
  outcome.report.seed = options.seed;
  outcome.report.method = options.method;
  ProgressLine progress(!options.quiet);
  const auto prepared = prepare_reference(options, settings, scene, progress, watch);
  if (!prepared) {
    outcome.report.outcome = interrupted() ? "interrupted" : "not_mapped";
    finish(folder, options, outcome, "");
    return outcome;
  }
  Worker worker(options.threads > 1);
  const auto simulator = make_simulator(options, settings, scene, catalogue, scattered, worker);
  score::Referee referee = make_referee(options, settings, scene, scattered, simulator->truth(), prepared->T_world_map);
  TidyRecording recording(*simulator, folder,
                          {options.record, options.seed, options.method, settings.mission.perception.floor_clearance_m,
                           prepared->reference, scene.world, options.threads > 1});
  const std::string artefacts =
      search(options, settings, {scene, *prepared, *simulator, referee, folder, *outcome.page, recording}, progress,
             outcome.report);
  outcome.report.wall_s = watch.seconds_s();
  finish(folder, options, outcome, artefacts);
  return outcome;
}

}  // namespace amiss::app
