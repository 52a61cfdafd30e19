// amiss scene RUN --out FILE: an instant of a run folder for MRPT's SceneViewer3D.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "core/result.hpp"
#include "page/run_files.hpp"
#include "page/scene_file.hpp"

namespace amiss::app {

namespace {

constexpr const char* kEnding = ".3Dscene";

struct Arguments {
  std::string folder, out;
  std::optional<double> at_s;
};

void save(const Arguments& a) {
  if (std::filesystem::path(a.out).extension() != kEnding)
    throw ArgumentError(a.out + ": a file that ends in " + kEnding + " is allowed");
  const page::Story story = page::load_story(a.folder);
  if (a.at_s > story.end_s) throw ArgumentError("--at is behind the end of the run");
  page::save_scene(a.out, story, a.at_s.value_or(story.end_s));
  std::cout << a.out << "\n";
}

}  // namespace

void add_scene_command(CLI::App& app, int& exit_status) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* scene = app.add_subcommand("scene", "a run folder as a 3D scene for MRPT's SceneViewer3D");
  scene->add_option("RUN", a->folder, "run folder of a tidy-up run, or of a scenario with --view")->type_name("DIR")->required();
  scene->add_option("--out", a->out, "the scene: .3Dscene")->type_name("FILE")->required();
  scene->add_option("--at", a->at_s, "simulated second that it shows; default: the end")->check(CLI::Range(0.0, 1e6));
  scene->callback([a, &exit_status] {
    save(*a);
    exit_status = kGoalMet;
  });
}

}  // namespace amiss::app
