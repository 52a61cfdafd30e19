#include "reference_cache.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include "core/files.hpp"
#include "resources.hpp"
#include "sim/simulator.hpp"
#include "world/fingerprint.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;

// Counts up when the mapping run changes, so that references of an older program are not used.
constexpr std::string_view kFormat = "reference 3";
constexpr std::size_t kIdDigits = 24;
constexpr double kMappingTimeLimit = 4.0 * 3600.0;  // s, simulated

}  // namespace

std::string reference_id(const MappingInput& input, Settings& settings) {
  const std::string start = fmt::format("{} {} {}", input.start.x_m, input.start.y_m, input.start.yaw_rad);
  return sha256(fmt::format("{}\n{}\n{}\n{}\n{}\n{}", kFormat, AMISS_VERSION, world::fingerprint(input.world),
                            sha256(load_bytes(input.robot_file)), start, settings.reference_key()))
      .substr(0, kIdDigits);
}

MappingOutcome run_mapping(const MappingInput& input, const Settings& settings, bool threaded, mission::Sinks sinks) {
  Worker worker(threaded);
  sim::Simulator simulator(input.world, input.model, settings.simulator, input.seed, input.start, worker);
  std::vector<score::PosePair> poses;
  sinks.step = [&, outer = sinks.step](const mission::StepEvent& event) {
    poses.push_back({event.pose.stamp, simulator.truth().T_world_base, event.pose.T_map_base});
    outer(event);
  };
  mission::Params params = settings.mission;
  params.perception.time_limit_s = kMappingTimeLimit;
  params.perception.threaded = threaded;
  MappingOutcome outcome;
  outcome.report = mission::make_reference(simulator, params, input.seed, sinks);
  outcome.T_world_map = score::align(poses);
  outcome.error = score::localization_error(poses, outcome.T_world_map);
  outcome.collisions = simulator.collisions().size();
  return outcome;
}

void save_prepared(const fs::path& folder, const mission::Reference& reference, const Pose2<World, Map>& T_world_map) {
  fs::create_directories(folder);
  mission::save_reference(folder, reference);
  save_atomically(folder / "alignment.yaml",
                  fmt::format("# How the map lies in the simulated world; for the referee only.\n"
                              "x_m: {:.9f}\ny_m: {:.9f}\nyaw_rad: {:.9f}\n",
                              T_world_map.x_m, T_world_map.y_m, T_world_map.yaw_rad));
}

PreparedReference load_prepared(const fs::path& folder, const Settings& settings) {
  const fs::path file = folder / "alignment.yaml";
  try {
    const YAML::Node node = YAML::Load(load_bytes(file, 4096));
    return {mission::load_reference(folder, settings.mission.voxels),
            {node["x_m"].as<double>(), node["y_m"].as<double>(), node["yaw_rad"].as<double>()}};
  } catch (const YAML::Exception&) {
    throw InputError(file.string() + ": x_m, y_m and yaw_rad are needed, each a number");
  }
}

std::optional<PreparedReference> cached_reference(const MappingInput& input, Settings& settings, bool threaded,
                                                  const mission::Sinks& sinks, const std::function<void()>& announce) {
  const fs::path folder = cache_folder() / "references" / reference_id(input, settings);
  if (fs::exists(folder / "alignment.yaml")) return load_prepared(folder, settings);
  announce();
  const MappingOutcome outcome = run_mapping(input, settings, threaded, sinks);
  if (!outcome.report.complete) return std::nullopt;
  // Made beside its place and renamed, so that it is there whole or not at all, also with two programs at work.
  const fs::path making = folder.string() + "." + std::to_string(::getpid());
  save_prepared(making, outcome.report.reference, outcome.T_world_map);
  std::error_code taken;
  fs::rename(making, folder, taken);
  if (taken) fs::remove_all(making);
  return load_prepared(folder, settings);  // from the files, as every later run
}

}  // namespace amiss::app
