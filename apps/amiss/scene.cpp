// amiss scene FOLDER --out FILE: an instant of a run, or a reconstructed room, for MRPT's SceneViewer3D.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/result.hpp"
#include "dataset/cloud_files.hpp"
#include "dataset/trajectory_files.hpp"
#include "page/run_files.hpp"
#include "page/scene_file.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;

constexpr const char *kEnding = ".3Dscene", *kCloud = "cloud.ply", *kTrajectory = "trajectory.txt";

struct Arguments {
  std::string folder, out;
  std::optional<double> at_s;
};

std::string bytes_of_run(const Arguments& a) {
  const page::Story story = page::load_story(a.folder);
  if (a.at_s > story.end_s) throw ArgumentError("--at is behind the end of the run");
  return page::scene_bytes(story, a.at_s.value_or(story.end_s));
}

/// Of a folder of `amiss reconstruct`.
std::string bytes_of_room(const fs::path& folder) {
  const fs::path trajectory = folder / kTrajectory;
  std::vector<Eigen::Vector3d> way;
  if (fs::exists(trajectory)) {
    for (const auto& pose : dataset::parse_tum_trajectory(load_bytes(trajectory), trajectory.string()))
      way.push_back(pose.T_map_camera.position());
  }
  return page::scene_bytes(dataset::load_cloud(folder / kCloud).cloud(), way);
}

void save(const Arguments& a) {
  if (fs::path(a.out).extension() != kEnding)
    throw ArgumentError(a.out + ": a file that ends in " + kEnding + " is allowed");
  const bool is_room = fs::exists(fs::path(a.folder) / kCloud);
  if (is_room && a.at_s) throw ArgumentError("--at is for run folders; " + a.folder + " is a reconstruction");
  page::save_scene(a.out, is_room ? bytes_of_room(a.folder) : bytes_of_run(a));
  std::cout << a.out << "\n";
}

}  // namespace

void add_scene_command(CLI::App& app, int& exit_status) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* scene = app.add_subcommand("scene", "a run or a reconstructed room as a 3D scene for MRPT's SceneViewer3D");
  scene->add_option("FOLDER", a->folder, "of a tidy-up run, of a scenario with --view, or of reconstruct")
      ->type_name("DIR")
      ->required();
  scene->add_option("--out", a->out, "the scene: .3Dscene")->type_name("FILE")->required();
  scene->add_option("--at", a->at_s, "of a run: the simulated second that it shows; default: the end")
      ->check(CLI::Range(0.0, 1e6));
  scene->callback([a, &exit_status] {
    save(*a);
    exit_status = kGoalMet;
  });
}

}  // namespace amiss::app
