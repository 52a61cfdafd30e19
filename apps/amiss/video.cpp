// amiss video RUN --out FILE: a film of a run folder.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "core/result.hpp"
#include "interrupt.hpp"
#include "kinds.hpp"
#include "page/run_files.hpp"
#include "progress_line.hpp"
#include "video/chase.hpp"
#include "video/film.hpp"
#include "video/frame.hpp"
#include "video/stage.hpp"

namespace amiss::app {

namespace {

struct Arguments {
  std::string folder, out, world;
  std::vector<std::string> model_paths;
  double speed = 8.0, from_s = 0.0;
  int frames_per_s = 25, width = 1280;
  bool quiet = false;
};

video::Stage make_stage(const Arguments& a, const page::Story& story) {
  const Resources resources = find_resources();
  world::LoadOptions load;
  for (const std::string& path : a.model_paths) load.model_paths.emplace_back(path);
  const std::string& world = a.world.empty() ? story.place.world : a.world;
  if (a.world.empty() && world.find('/') != std::string::npos && !std::filesystem::exists(world))
    throw InputError(world + ": the world of the run is not there any more; --world says where it is now");
  std::set<std::string> kinds;
  for (const auto& [t, body] : story.bodies) kinds.insert(body.kind);
  return {world::load_world(find_world(resources, world), load), load_kinds(resources, kinds, load),
          robot::load_model(story.place.robot.empty() ? resources.robot : std::filesystem::path(story.place.robot)),
          story};
}

int run(const Arguments& a) {
  catch_interrupts();
  const page::Story story = page::load_story(a.folder);
  if (a.from_s > story.end_s) throw ArgumentError("--from is behind the end of the run");
  video::Film film(a.out, {a.frames_per_s, a.width});
  video::Stage stage = make_stage(a, story);
  const video::FilmTimes times{a.speed, a.frames_per_s, a.from_s, story.end_s};
  const auto cameras = video::chase(story, times);
  ProgressLine progress(!a.quiet);
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    if (interrupted()) return kInterrupted;
    const double t_s = times.at_s(i);
    const page::Slice* seen = page::latest(story.pictures, t_s);
    const std::string camera = seen == nullptr ? "" : page::load_picture(a.folder, *seen);
    film.add(
        video::compose(story, t_s, {stage.picture(t_s, cameras[i], video::third_person_camera()), cameras[i]}, camera));
    progress.show("frame " + std::to_string(i + 1) + " of " + std::to_string(cameras.size()));
  }
  film.finish();
  progress.clear();
  if (!a.quiet) std::cout << a.out << "\n";
  return kGoalMet;
}

}  // namespace

void add_video_command(CLI::App& app, int& exit_status) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* video = app.add_subcommand("video", "a film of a run folder: the robot from behind, its camera, its map");
  video->add_option("RUN", a->folder, "run folder of a tidy-up run, or of a scenario with --view")
      ->type_name("DIR")
      ->required();
  video->add_option("--out", a->out, "the film: .mp4 or .gif")->type_name("FILE")->required();
  video->add_option("--speed", a->speed, "simulated seconds in a second of the film")
      ->check(CLI::Range(0.1, 1000.0))
      ->capture_default_str();
  video->add_option("--fps", a->frames_per_s, "frames a second")->check(CLI::Range(1, 60))->capture_default_str();
  const CLI::Validator even(
      [](const std::string& text) { return text.find_last_of("02468") + 1 == text.size() ? "" : "has to be even"; },
      "even");
  video->add_option("--width", a->width, "of the picture [px], even")
      ->check(CLI::Range(160, 3840) & even)
      ->capture_default_str();
  video->add_option("--from", a->from_s, "simulated second that the film begins with")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  video->add_option("--world", a->world, "name or SDF file, where the run's own is elsewhere now")->type_name("WORLD");
  video->add_option("--model-path", a->model_paths, "folder searched for model:// names; may be repeated")
      ->type_name("DIR");
  video->add_flag("--quiet", a->quiet, "no progress");
  video->callback([a, &exit_status] { exit_status = run(*a); });
}

}  // namespace amiss::app
