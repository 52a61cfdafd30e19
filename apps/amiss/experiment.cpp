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
  int jobs = 2;  // of `plan`
};

void add_plan(CLI::App& experiment, const std::shared_ptr<Arguments>& a, int& exit_status) {
  CLI::App* plan = experiment.add_subcommand("plan", "the trials, their ids, how long it will take");
  plan->add_option("SPEC", a->spec, "YAML file of the experiment")->type_name("FILE")->required();
  plan->add_option("-j,--jobs", a->jobs, "trials at a time")->check(CLI::Range(1, 1024))->capture_default_str();
  plan->callback([a, &exit_status] { exit_status = plan_experiment(a->spec, a->jobs); });
}

void add_engine_options(CLI::App& run, ExperimentOptions& o) {
  run.add_option("--engine", o.engine, "who does them: this program, job arrays of Slurm, GNU parallel [local]")
      ->check(CLI::IsMember({kLocalEngine, kSlurmEngine, kParallelEngine}))
      ->option_text("local|slurm|parallel");
  run.add_option("--chunk", o.chunk, "trials for each task [10 with slurm, 1 with parallel]")
      ->check(CLI::Range(1, 10000));
  run.add_flag("--print", o.print, "with slurm: print the scripts of the job arrays and do nothing");
  run.add_option("--sbatch", o.sbatch, "with slurm: an option of sbatch, such as --sbatch=--partition=short")
      ->type_name("OPTION")
      ->allow_extra_args(false);
  run.add_option("--sshlogin", o.logins, "with parallel: machines, as GNU parallel names them, such as 8/host1,host2")
      ->type_name("LOGIN")
      ->allow_extra_args(false);
}

void add_run(CLI::App& experiment, const std::shared_ptr<Arguments>& a, int& exit_status) {
  ExperimentOptions& o = a->options;
  CLI::App* run = experiment.add_subcommand("run", "do what has no result yet");
  run->add_option("SPEC", a->spec, "YAML file of the experiment")->type_name("FILE")->required();
  run->add_option("--out", o.out, "its folder; one that was begun is taken up again [runs/SPEC]")->type_name("DIR");
  run->add_option("-j,--jobs", o.jobs, "trials at a time [2; with slurm as many as there is room for]")
      ->check(CLI::Range(1, 1024));
  add_engine_options(*run, o);
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
