#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "core/result.hpp"
#include "experiment_merge.hpp"
#include "experiment_run.hpp"

namespace amiss::app {

namespace {

struct Arguments {
  ExperimentOptions options;
  std::string spec, folder;
  std::vector<std::string> ids;
};

void add_plan(CLI::App& experiment, const std::shared_ptr<Arguments>& a, int& exit_status) {
  CLI::App* plan = experiment.add_subcommand("plan", "the trials, their ids, how long it will take");
  plan->add_option("SPEC", a->spec, "YAML file of the experiment")->type_name("FILE")->required();
  plan->add_option("-j,--jobs", a->options.jobs, "trials at a time")->check(CLI::Range(1, 1024))->capture_default_str();
  plan->callback([a, &exit_status] { exit_status = plan_experiment(a->spec, a->options.jobs); });
}

void add_run(CLI::App& experiment, const std::shared_ptr<Arguments>& a, int& exit_status) {
  ExperimentOptions& o = a->options;
  CLI::App* run = experiment.add_subcommand("run", "do what has no result yet");
  run->add_option("SPEC", a->spec, "YAML file of the experiment")->type_name("FILE")->required();
  run->add_option("--out", o.out, "its folder; one that was begun is taken up again [runs/SPEC]")->type_name("DIR");
  run->add_option("-j,--jobs", o.jobs, "trials at a time")->check(CLI::Range(1, 1024))->capture_default_str();
  run->add_flag("--retry-failed", o.retry_failed, "also do again what failed");
  run->callback([a, &exit_status] { exit_status = run_experiment(a->spec, a->options); });
}

void add_on_folder(CLI::App& experiment, const std::shared_ptr<Arguments>& a, int& exit_status, const char* name,
                   const char* what, int (*act)(const std::filesystem::path&)) {
  CLI::App* command = experiment.add_subcommand(name, what);
  command->add_option("DIR", a->folder, "folder of the experiment")->type_name("DIR")->required();
  command->callback([a, &exit_status, act] { exit_status = act(a->folder); });
}

}  // namespace

void add_experiment_command(CLI::App& app, int& exit_status) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* experiment = app.add_subcommand("experiment", "many trials of both methods, and what they say");
  experiment->require_subcommand(1);
  add_plan(*experiment, a, exit_status);
  add_run(*experiment, a, exit_status);
  CLI::App* work = experiment->add_subcommand("work", "do these trials here: what the tasks of a cluster call");
  work->add_option("DIR", a->folder, "folder of the experiment")->type_name("DIR")->required();
  work->add_option("ID", a->ids, "of the trials")->required();
  work->callback([a, &exit_status] { exit_status = work_on_experiment(a->folder, a->ids); });
  add_on_folder(*experiment, a, exit_status, "status", "what is done, failed and missing", show_experiment);
  add_on_folder(*experiment, a, exit_status, "merge", "the results as tables, and what they say", merge_experiment);
  add_on_folder(*experiment, a, exit_status, "plot", "figures, and report.html with all of it", plot_experiment);
  add_on_folder(*experiment, a, exit_status, "verify", "whether nothing is lost, doubled or changed",
                verify_experiment);
}

}  // namespace amiss::app
