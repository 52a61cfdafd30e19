#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "core/result.hpp"
#include "run_page.hpp"
#include "tidy_run.hpp"

namespace amiss::app {

void add_tidy_command(CLI::App& app, int& exit_status) {
  struct Arguments {
    TidyOptions options;
    int objects = -1;
    std::string until = "found", params_file;
    std::vector<std::string> overrides;
    bool json = false, print_params = false;
  };
  const auto a = std::make_shared<Arguments>();
  CLI::App* tidy = app.add_subcommand("tidy", "search a flat for what lies on its floor and did not lie there before");
  tidy->add_option("--world", a->options.world, "name (see `amiss worlds`) or SDF file")
      ->type_name("WORLD")
      ->capture_default_str();
  tidy->add_option("--reference-world", a->options.reference_world, "SDF file of the tidy state, if it is another one")
      ->type_name("WORLD");
  tidy->add_option("--objects", a->objects, "how many objects are scattered [5]")->check(CLI::Range(0, 100));
  tidy->add_option("--scatter", a->options.scatter_file, "YAML file that says what lies where instead")
      ->type_name("FILE");
  tidy->add_option("--seed", a->options.seed, "of everything random")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  tidy->add_option("--scatter-seed", a->options.scatter_seed, "of what is scattered where, if not --seed")
      ->check(CLI::NonNegativeNumber);
  tidy->add_option("--method", a->options.method, "segment what differs from the map, or at every view triangle")
      ->check(CLI::IsMember({"dynamic", "static"}))
      ->capture_default_str();
  tidy->add_option("--until", a->until, "end when all was found (the referee tells) or when the robot has seen all")
      ->check(CLI::IsMember({"found", "explored"}))
      ->capture_default_str();
  tidy->add_option("--time-limit", a->options.time_limit_s, "simulated seconds")
      ->check(CLI::Range(1.0, 1e6))
      ->capture_default_str();
  tidy->add_option("--params", a->params_file, "YAML file of parameters")->type_name("FILE");
  tidy->add_option("--set", a->overrides, "key=value, overrides a parameter; may be repeated")->type_name("KEY=VALUE");
  tidy->add_option("--out", a->options.out, "run folder [runs/tidy-WORLD-SEED]")->type_name("DIR");
  tidy->add_option("--robot", a->options.robot, "URDF file of another robot")->type_name("FILE");
  tidy->add_option("--model-path", a->options.model_paths, "folder searched for model:// names; may be repeated")
      ->type_name("DIR");
  tidy->add_option("--start", a->options.start, "where the robot begins: X,Y,HEADING of the world in m and degrees")
      ->delimiter(',')
      ->expected(3)
      ->check(CLI::Range(-1e4, 1e4));
  tidy->add_option("--threads", a->options.threads, "1 or 2; the result is the same")->check(CLI::Range(1, 2));
  tidy->add_option("--record", a->options.record, "recording.mcap (ROS 2), recording.rawlog (MRPT) in the run folder")
      ->check(CLI::IsMember({"mcap", "rawlog", "both"}));
  add_view_options(*tidy, a->options.view, true);
  tidy->add_flag("--json", a->json, "print report.json and nothing else on standard output");
  tidy->add_flag("--quiet", a->options.quiet, "no progress, no table");
  tidy->add_flag("--print-params", a->print_params, "print all parameters with ranges and meanings, and end");
  tidy->callback([a, &exit_status] {
    if (std::isnan(a->options.time_limit_s)) throw ArgumentError("--time-limit nan: 1 .. 1000000 s are allowed");
    Settings settings = load_settings(a->params_file, a->overrides);
    if (a->print_params) {
      std::cout << settings.table().to_yaml();
      return;
    }
    a->options.until_found = a->until == "found";
    if (a->objects >= 0) a->options.objects = a->objects;
    const TidyOutcome outcome = run_tidy(a->options, std::move(settings));
    exit_status = outcome.exit_status;
    if (a->json) {
      std::cout << outcome.json;
    } else if (!a->options.quiet) {
      std::cout << report::to_table(outcome.report) << "run folder: " << outcome.folder << "\n";
    }
    std::cout.flush();
    outcome.page->linger();
  });
}

}  // namespace amiss::app
