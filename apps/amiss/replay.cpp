// amiss replay FILE: perception of a recorded run, without the simulator.
#include "recording/replay.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/result.hpp"
#include "interrupt.hpp"
#include "mapping/voxel_files.hpp"
#include "report/run_folder.hpp"
#include "settings.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string file, out;
  bool json = false, quiet = false;
};

/// The documents of a recording as files, as long as this lives.
class Unpacked {
 public:
  explicit Unpacked(const std::map<std::string, std::string>& documents) {
    std::string name = (fs::temp_directory_path() / "amiss_replay_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": cannot be made");
    folder_ = name;
    for (const auto& [document, bytes] : documents) save_atomically(folder_ / fs::path(document).filename(), bytes);
  }
  ~Unpacked() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Unpacked(const Unpacked&) = delete;
  Unpacked& operator=(const Unpacked&) = delete;
  [[nodiscard]] const fs::path& path() const { return folder_; }

 private:
  fs::path folder_;
};

nlohmann::ordered_json json_of(const recording::ReplayReport& report, const knowledge::Knowledge& known) {
  nlohmann::ordered_json regions = nlohmann::ordered_json::array(), objects = regions;
  for (const knowledge::Region& r : known.regions) {
    const knowledge::Cylinder& c = r.cylinder;
    regions.push_back({{"id", r.id},
                       {"centre", {c.centre_map.x(), c.centre_map.y()}},
                       {"radius_m", c.radius_m},
                       {"z", {c.z_low_m, c.z_high_m}},
                       {"first_seen_s", seconds(r.first_seen)},
                       {"examined", r.examined},
                       {"withdrawn", r.withdrawn}});
  }
  for (const knowledge::Object& o : known.objects) {
    objects.push_back({{"id", o.id},
                       {"region", o.region},
                       {"centre", {o.centre_map.x(), o.centre_map.y(), o.centre_map.z()}},
                       {"size", {o.size_m.x(), o.size_m.y(), o.size_m.z()}}});
  }
  return {{"schema", 1},
          {"version", AMISS_VERSION},
          {"complete", report.complete},
          {"simulated_s", seconds(report.pose.stamp)},
          {"periods", report.periods},
          {"frames", report.frames},
          {"comparisons", report.comparisons},
          {"segmentations", report.segmentations},
          {"regions", regions},
          {"objects", objects}};
}

void print(const recording::ReplayReport& report, const knowledge::Knowledge& known) {
  std::cout << fmt::format("{:>6}  {:>18}  {:>8}  {:>9}  {}\n", "region", "where (map)", "radius", "first", "state");
  for (const knowledge::Region& r : known.regions) {
    std::cout << fmt::format("{:>6}  ({:7.3f}, {:7.3f})  {:6.3f} m  {:7.1f} s  {}\n", r.id, r.cylinder.centre_map.x(),
                             r.cylinder.centre_map.y(), r.cylinder.radius_m, seconds(r.first_seen),
                             r.withdrawn  ? "withdrawn"
                             : r.examined ? "examined"
                                          : "open");
  }
  std::cout << fmt::format("{} frames, {} comparisons, {} segmentations, {} objects in {:.1f} s (recorded){}\n",
                           report.frames, report.comparisons, report.segmentations, known.objects.size(),
                           seconds(report.pose.stamp), report.complete ? "" : "; the recording breaks off here");
}

int run(const Arguments& a) {
  catch_interrupts();
  const auto source = recording::open_source(a.file);
  for (const char* name : {"params.yaml", "map.yaml", "map.pgm", "mapped.ot", "reference.ot"}) {
    if (!source->documents().contains(name)) throw InputError(a.file + ": " + name + " is not attached to it");
  }
  const Unpacked unpacked(source->documents());
  Settings settings = load_settings(unpacked.path() / "params.yaml", {});
  settings.mission.perception.time_limit_s = std::numeric_limits<double>::infinity();  // the recording ends it
  const mission::Reference reference = mission::load_reference(unpacked.path(), settings.mission.voxels);
  std::optional<report::RunFolder> folder;
  if (!a.out.empty()) folder.emplace(fs::path(a.out));
  knowledge::KnowledgeBase knowledge =
      folder ? knowledge::KnowledgeBase(folder->path() / "knowledge.sqlite", settings.mission.knowledge)
             : knowledge::KnowledgeBase(settings.mission.knowledge);
  mission::Sinks sinks;
  sinks.stop = interrupted;
  const recording::ReplayReport report = recording::replay(*source, reference, settings.mission, knowledge, sinks);
  const std::string json = json_of(report, knowledge.now()).dump(2) + "\n";
  if (folder) {
    folder->save("current.ot", mapping::voxel_map_bytes(report.voxels, mapping::VoxelFormat::kOt));
    knowledge.close();
    interrupted() ? folder->interrupt(json) : folder->finish(json);
  }
  if (a.json) {
    std::cout << json;
  } else if (!a.quiet) {
    print(report, knowledge.now());
  }
  return interrupted() ? kInterrupted : kGoalMet;
}

}  // namespace

void add_replay_command(CLI::App& app, int& exit_status) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("replay", "perception of a recorded run once more, without the simulator");
  command->add_option("FILE", a->file, "recording.mcap or recording.rawlog of `amiss tidy --record`")
      ->type_name("FILE")
      ->required();
  command->add_option("--out", a->out, "folder for knowledge.sqlite, current.ot and report.json")->type_name("DIR");
  command->add_flag("--json", a->json, "print report.json and nothing else on standard output");
  command->add_flag("--quiet", a->quiet, "no table");
  command->callback([a, &exit_status] { exit_status = run(*a); });
}

}  // namespace amiss::app
