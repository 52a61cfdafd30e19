// amiss detect REFERENCE CURRENT: what is in a reconstructed room and was not there before (chapter 5).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "core/result.hpp"
#include "dataset/room_folders.hpp"
#include "detect_output.hpp"
#include "detect_settings.hpp"
#include "report/run_folder.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Arguments {
  std::string reference, current, out, method = "local-verification";
  std::string reference_space, current_space;
  DetectSettings settings;
  bool print_params = false, quiet = false;
};

struct Pair {
  SceneSource reference, current;
  fs::path out;
};

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

SceneSource source_of(const dataset::SceneFiles& scene) { return {scene.cloud, scene.space}; }

/// The reference of a room's folder, or the cloud that is given.
SceneSource reference_of(const std::string& path) {
  if (!dataset::is_room_folder(path)) return scene_source(path);
  const dataset::RoomFolder room = dataset::room_folders(path).front();
  const dataset::SceneFiles* first = room.scene(1);
  if (first == nullptr) throw InputError(path + ": has no scene1.pcd (or .ply), the reference of a room");
  return source_of(*first);
}

/// One current cloud, or all scenes of a room but its reference, each with an output folder of its own.
std::vector<Pair> pairs_of(const Arguments& a) {
  const SceneSource reference = reference_of(a.reference);
  std::vector<Pair> pairs;
  if (!dataset::is_room_folder(a.current)) {
    pairs.push_back({reference, scene_source(a.current), a.out});
  } else {
    const dataset::RoomFolder room = dataset::room_folders(a.current).front();
    for (const dataset::SceneFiles& scene : room.scenes) {
      if (scene.number != 1) pairs.push_back({reference, source_of(scene), fs::path(a.out) / scene.name()});
    }
    if (pairs.empty()) throw InputError(a.current + ": has no scene beside the reference");
  }
  for (Pair& pair : pairs) {
    if (!a.reference_space.empty()) pair.reference.space = a.reference_space;
    if (!a.current_space.empty()) pair.current.space = a.current_space;
  }
  return pairs;
}

nlohmann::ordered_json report_of(const Arguments& a, const Pair& pair, const LoadedScene& reference,
                                 const LoadedScene& current, const change::Detection& detection) {
  nlohmann::ordered_json verdicts = nlohmann::ordered_json::object();
  for (const change::Decision& d : detection.decisions) {
    auto& count = verdicts[std::string(change::name_of(d.verdict))];
    count = count.is_null() ? 1 : count.get<int>() + 1;
  }
  return {{"schema", "amiss.detect.1"},
          {"version", AMISS_VERSION},
          {"method", a.method},
          {"reference", pair.reference.cloud.string()},
          {"current", pair.current.cloud.string()},
          {"labels", {{"reference", reference.labels}, {"current", current.labels}}},
          {"space", {{"reference", reference.space}, {"current", current.space}}},
          {"points", {{"reference", reference.in_file.size()}, {"current", current.in_file.size()}}},
          {"support_planes", detection.planes},
          {"shift_m", {detection.shift_m.x(), detection.shift_m.y(), detection.shift_m.z()}},
          {"turn_deg", degrees(detection.turn_rad)},
          {"objects", detection.objects.size()},
          {"verdicts", verdicts}};
}

void detect(const Arguments& a, const Pair& pair) {
  const auto begin = Clock::now();
  const auto [reference, current] = load_scenes(pair.reference, pair.current, a.settings.labels);
  check_labels(a.method, current);
  const double read_s = seconds_since(begin);
  const report::RunFolder folder(pair.out);
  folder.save("params.yaml", a.settings.as_yaml());
  const auto detecting = Clock::now();
  const change::Detection detection = change::detect_novel(reference.scene, current.scene, a.method, a.settings.params);
  const double detect_s = seconds_since(detecting);
  const auto objects = points_in_file(detection, current);
  folder.save("detected.ply", dataset::ply_bytes(painted(current, objects)));
  folder.save("objects.json", objects_json(detection, a.settings.params).dump(2) + "\n");
  folder.save("objects.png", picture_of(current, objects));
  auto report = report_of(a, pair, reference, current, detection);
  report["wall"] = {{"read_s", read_s}, {"detect_s", detect_s}};
  folder.finish(report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  if (a.quiet) return;
  std::cout << fmt::format("{}: {} objects by {} in {:.1f} s, labels: {}\n", pair.current.cloud.string(),
                           objects.size(), a.method, detect_s, current.labels);
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const change::NovelObject& o = detection.objects[k];
    const Eigen::Vector3d centre = 0.5 * (o.low_m + o.high_m), size = o.high_m - o.low_m;
    std::cout << fmt::format("{:>3}  at {:.2f} {:.2f} {:.2f} m  {:.2f} x {:.2f} x {:.2f} m  {} points\n", k + 1,
                             centre.x(), centre.y(), centre.z(), size.x(), size.y(), size.z(), o.points.size());
  }
}

int run(const Arguments& a) {
  if (a.print_params) {
    std::cout << a.settings.as_yaml();
    return kGoalMet;
  }
  if (a.reference.empty() || a.current.empty() || a.out.empty()) {
    throw ArgumentError("REFERENCE, CURRENT and --out are needed; see amiss detect --help");
  }
  for (const Pair& pair : pairs_of(a)) detect(a, pair);
  return kGoalMet;
}

}  // namespace

void add_detect_command(CLI::App& app, int& exit_status) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* const command = app.add_subcommand("detect", "what is in a reconstructed room and was not there before");
  command
      ->add_option("REFERENCE", a->reference,
                   "cloud (PLY, PCD), folder of a reconstruction, or folder of a room (its scene1)")
      ->type_name("FILE");
  command->add_option("CURRENT", a->current, "the same; of a room's folder all other scenes")->type_name("FILE");
  command->add_option("--out", a->out, "folder to write")->type_name("DIR");
  command->add_option("--method", a->method, "how")
      ->check(CLI::IsMember(change::detection_methods()))
      ->capture_default_str();
  command->add_option("--reference-space", a->reference_space, "OctoMap of the space that the reference saw")
      ->type_name("FILE");
  command->add_option("--current-space", a->current_space, "OctoMap of the space that was seen now")->type_name("FILE");
  a->settings.add_options(*command);
  command->add_flag("--print-params", a->print_params, "print all parameters as YAML and end");
  command->add_flag("--quiet", a->quiet, "no summary");
  command->callback([a, &exit_status] {
    a->settings.load();
    exit_status = run(*a);
  });
}

}  // namespace amiss::app
