// amiss replay FILE: perception of a recorded run, without the simulator.
#include "recording/replay.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <CLI/CLI.hpp>
#include <algorithm>
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
  std::string file, out, reference, params_file;
  std::vector<std::string> overrides;
  std::vector<double> start;  // m, m, degrees
  dataset::RobotBagOptions bag;
  std::vector<const CLI::Option*> of_bags;
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

nlohmann::ordered_json json_of(const recording::ReplayReport& report, std::size_t dropped,
                               const knowledge::Knowledge& known) {
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
          {"dropped", dropped},
          {"comparisons", report.comparisons},
          {"segmentations", report.segmentations},
          {"regions", regions},
          {"objects", objects}};
}

void print(const recording::ReplayReport& report, std::size_t dropped, const knowledge::Knowledge& known) {
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
  if (dropped > 0)
    std::cout << fmt::format("{} scans and frames have no odometry or no transform near them\n", dropped);
}

/// What the recording was made with, or what the user says instead.
struct Basis {
  Settings settings;
  mission::Reference reference;
};

InputError no_reference(const Arguments& a) {
  return InputError(a.file + ": holds no reference; --reference DIR names a folder of `amiss map`");
}

Basis basis_of(const Arguments& a, const recording::Source& source) {
  const auto& documents = source.documents();
  if (a.reference.empty()) {
    if (documents.empty()) throw no_reference(a);
    for (const char* name : {"params.yaml", "map.yaml", "map.pgm", "mapped.ot", "reference.ot"}) {
      if (!documents.contains(name)) throw InputError(a.file + ": " + name + " is not attached to it");
    }
  }
  const Unpacked unpacked(documents);
  const fs::path folder = a.reference.empty() ? unpacked.path() : fs::path(a.reference);
  fs::path params = a.params_file;
  if (params.empty()) params = (documents.empty() ? folder : unpacked.path()) / "params.yaml";
  if (a.params_file.empty() && !fs::exists(params)) params.clear();
  Settings settings = load_settings(params, a.overrides);
  settings.mission.perception.time_limit_s = std::numeric_limits<double>::infinity();  // the recording ends it
  return {settings, mission::load_reference(folder, settings.mission.voxels)};
}

int run(const Arguments& a) {
  recording::BagSetting bag{a.bag, {}};
  const auto given = [&](const char* option) {
    return std::any_of(a.of_bags.begin(), a.of_bags.end(),
                       [&](const CLI::Option* one) { return one->count() > 0 && one->check_lname(option); });
  };
  bag.bag.is_odometry_needed = given("odometry-topic");
  bag.bag.is_colour_needed = given("colour-topic");
  if (!a.start.empty()) bag.T_map_base = {a.start.at(0), a.start.at(1), radians(a.start.at(2))};
  if (a.reference.empty() && dataset::RobotBag::is_bag(a.file)) throw no_reference(a);  // reading it takes long
  const auto source = recording::open_source(a.file, bag);
  catch_interrupts();  // not before: nobody asks while a bag is read
  for (const CLI::Option* option : a.of_bags) {
    if (option->count() == 0 || !source->tells_decisions()) continue;
    throw ArgumentError(a.file + ": is the recording of a run, which says that itself; " + option->get_name() +
                        " is for bags");
  }
  const auto [settings, reference] = basis_of(a, *source);
  std::optional<report::RunFolder> folder;
  if (!a.out.empty()) folder.emplace(fs::path(a.out));
  knowledge::KnowledgeBase knowledge =
      folder ? knowledge::KnowledgeBase(folder->path() / "knowledge.sqlite", settings.mission.knowledge)
             : knowledge::KnowledgeBase(settings.mission.knowledge);
  mission::Sinks sinks;
  sinks.stop = interrupted;
  const recording::ReplayReport report = recording::replay(*source, reference, settings.mission, knowledge, sinks);
  const std::string json = json_of(report, source->dropped(), knowledge.now()).dump(2) + "\n";
  if (folder) {
    folder->save("current.ot", mapping::voxel_map_bytes(report.voxels, mapping::VoxelFormat::kOt));
    knowledge.close();
    interrupted() ? folder->interrupt(json) : folder->finish(json);
  }
  if (a.json) {
    std::cout << json;
  } else if (!a.quiet) {
    print(report, source->dropped(), knowledge.now());
  }
  return interrupted() ? kInterrupted : kGoalMet;
}

void add_bag_options(CLI::App& command, Arguments& a) {
  a.of_bags.push_back(
      command
          .add_option("--start", a.start,
                      "of a bag: where on the map the robot begins, X,Y,HEADING in m and degrees [0,0,0]")
          ->delimiter(',')
          ->expected(3)
          ->check(CLI::Range(-1e4, 1e4)));
  const auto add = [&](const char* name, std::string& value, const std::string& what) {
    a.of_bags.push_back(command.add_option(name, value, "of a bag: " + what)->type_name("NAME")->capture_default_str());
  };
  add("--odometry-topic", a.bag.odometry_topic, "nav_msgs/Odometry; where it is missing, /tf says the same");
  add("--scan-topic", a.bag.scan_topic, "sensor_msgs/LaserScan");
  add("--depth-topic", a.bag.depth_topic,
      "sensor_msgs/Image, 16UC1 in mm or 32FC1 in m, its camera_info beside it; else NAME/compressedDepth");
  add("--colour-topic", a.bag.colour_topic,
      "sensor_msgs/Image, registered, else NAME/compressed; without it nothing is segmented");
  add("--odom-frame", a.bag.odom_frame, "frame of /tf in which odometry moves the robot");
  add("--base-frame", a.bag.base_frame, "frame of /tf on the floor in the middle of the robot");
  a.of_bags.push_back(command
                          .add_option("--frame-period", a.bag.frame_period_s,
                                      "of a bag: frames that come sooner after the last are left out, s")
                          ->type_name("S")
                          ->check(CLI::Range(0.0, 60.0))
                          ->capture_default_str());
}

}  // namespace

void add_replay_command(CLI::App& app, int& exit_status) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("replay", "perception of a recorded run once more, without the simulator");
  command
      ->add_option("FILE", a->file,
                   "recording.mcap or recording.rawlog of `amiss tidy --record`, or a ROS 1 bag of an HSR")
      ->type_name("FILE")
      ->required();
  command->add_option("--out", a->out, "folder for knowledge.sqlite, current.ot and report.json")->type_name("DIR");
  command
      ->add_option("--reference", a->reference,
                   "folder of `amiss map` to compare with; a bag needs one [what the recording holds]")
      ->type_name("DIR");
  command->add_option("--params", a->params_file, "YAML file of parameters [of the recording, else of the reference]")
      ->type_name("FILE");
  command->add_option("--set", a->overrides, "key=value, overrides a parameter; may be repeated")
      ->type_name("KEY=VALUE");
  add_bag_options(*command, *a);
  command->add_flag("--json", a->json, "print report.json and nothing else on standard output");
  command->add_flag("--quiet", a->quiet, "no table");
  command->callback([a, &exit_status] { exit_status = run(*a); });
}

}  // namespace amiss::app
