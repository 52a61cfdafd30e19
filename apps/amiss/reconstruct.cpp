// amiss reconstruct RECORDING: points, triangles and seen space of a recorded room.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "core/result.hpp"
#include "interrupt.hpp"
#include "progress_line.hpp"
#include "reconstruct_recording.hpp"
#include "reconstruct_run.hpp"

namespace amiss::app {
namespace {

struct Arguments {
  std::string recording, out, method, params_file, poses, colour_topic, depth_topic, map_frame = "map";
  std::vector<std::string> overrides;
  std::vector<double> intrinsics;
  double voxel_m = 0.0, depth_scale = 0.0;
  int every = 1, threads = 1;
  bool refine = false, print_params = false, quiet = false;
};

mapping::ReconstructionParams params_of(const Arguments& a, std::string* as_yaml) {
  mapping::ReconstructionParams params;
  ParamTable table;
  describe(table, params);
  if (!a.params_file.empty()) table.load_file(a.params_file);
  if (!a.method.empty()) table.set("reconstruct.method", a.method, "--method");
  if (a.voxel_m != 0.0) table.set("surface.voxel", fmt::format("{}", a.voxel_m), "--voxel");
  if (a.refine) params.refine = true;
  for (const std::string& assignment : a.overrides) table.set_override(assignment);
  *as_yaml = table.to_yaml();
  return params;
}

dataset::RecordingOptions options_of(const Arguments& a) {
  dataset::RecordingOptions options;
  options.intrinsics = intrinsics_of(a.intrinsics);
  if (a.depth_scale != 0.0) options.depth_scale = a.depth_scale;
  options.colour_topic = a.colour_topic;
  options.depth_topic = a.depth_topic;
  options.map_frame = a.map_frame;
  options.poses = a.poses;
  return options;
}

/// The last two parts of the path: recordings are called scene2 in the folder of their room.
std::string stem_of(const std::filesystem::path& recording) {
  const std::filesystem::path whole = std::filesystem::absolute(recording / "").lexically_normal().parent_path();
  const std::string room = whole.parent_path().filename().string(), scene = whole.filename().string();
  return room.empty() ? scene : room + "-" + scene;
}

int run(const Arguments& a) {
  catch_interrupts();
  std::string as_yaml;
  const mapping::ReconstructionParams params = params_of(a, &as_yaml);
  if (a.print_params) {
    std::cout << as_yaml;
    return kGoalMet;
  }
  const auto recording = open_any_recording(a.recording, options_of(a));
  (void)mapping::make_reconstructor(params);  // refuses wrong parameters before a folder is made
  const report::RunFolder folder(a.out.empty() ? report::unused_folder("runs", "reconstruct-" + stem_of(a.recording))
                                               : std::filesystem::path(a.out));
  folder.save("params.yaml", as_yaml);
  ProgressLine progress(!a.quiet);
  ReconstructJob job{*recording, a.recording, params, static_cast<std::size_t>(a.every), a.threads > 1};
  job.stop = interrupted;
  job.progress = [&](const std::string& line) { progress.show(line); };
  const std::string summary = reconstruct(job, folder);
  progress.clear();
  if (summary.empty()) {
    folder.interrupt("{\"schema\": \"amiss.reconstruction.1\", \"outcome\": \"interrupted\"}\n");
    return kInterrupted;
  }
  if (!a.quiet) std::cout << summary;
  return kGoalMet;
}

}  // namespace

void add_reconstruct_command(CLI::App& app, int& exit_status) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* const command = app.add_subcommand("reconstruct", "points, triangles and seen space of a recorded room");
  command
      ->add_option("RECORDING", a->recording,
                   "folder of a recording (TUM RGB-D, 7-Scenes or Open3D), ROS 1 bag or MRPT rawlog")
      ->type_name("FILE")
      ->required();
  command->add_option("--out", a->out, "folder to write [runs/reconstruct-RECORDING]")->type_name("DIR");
  command->add_option("--voxel", a->voxel_m, "edge of a voxel in m [0.01]")->check(CLI::Range(0.001, 0.5));
  command->add_option("--method", a->method, "tsdf (default) or octomap");
  command->add_flag("--refine", a->refine, "refine poses against the model by ICP");
  command->add_option("--every", a->every, "only the first of so many frames")->check(CLI::Range(1, 100000));
  command->add_option("--threads", a->threads, "2: images are read beside the work")->check(CLI::Range(1, 2));
  command->add_option("--intrinsics", a->intrinsics, "FX,FY,CX,CY of the camera in pixels")
      ->delimiter(',')
      ->expected(4)
      ->check(CLI::Range(0.0, 1e5));
  command->add_option("--depth-scale", a->depth_scale, "units of the depth images for a metre")
      ->check(CLI::Range(1.0, 1e6));
  command->add_option("--colour-topic", a->colour_topic, "of a bag [the HSR's, else the only one]");
  command->add_option("--depth-topic", a->depth_topic, "of a bag [the HSR's, else the only one]");
  command->add_option("--map-frame", a->map_frame, "of a bag: the frame of its poses")->capture_default_str();
  command->add_option("--poses", a->poses, "of a TUM folder or a rawlog: another TUM trajectory of the camera")
      ->type_name("FILE");
  command->add_option("--params", a->params_file, "YAML file of parameters")->type_name("FILE");
  command->add_option("--set", a->overrides, "key=value, overrides a parameter; may be repeated");
  command->add_flag("--print-params", a->print_params, "print all parameters as YAML and end");
  command->add_flag("--quiet", a->quiet, "no progress, no summary");
  command->callback([a, &exit_status] { exit_status = run(*a); });
}

}  // namespace amiss::app
