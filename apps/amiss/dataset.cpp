#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "dataset_annotate.hpp"
#include "dataset_make.hpp"

namespace amiss::app {

namespace {

void add_make(CLI::App& dataset, int& exit_status) {
  const auto o = std::make_shared<DatasetOptions>();
  CLI::App* make = dataset.add_subcommand("make", "place objects in the five rooms and record each visit");
  make->add_option("--out", o->out, "folder of the data set; one that is not finished is continued")
      ->type_name("DIR")
      ->required();
  make->add_option("--rooms", o->rooms, "of sim_worlds/dataset.yaml, separated by commas [all]")->delimiter(',');
  make->add_option("--visits", o->visits, "at most so many of each room after the tidy one [all]")
      ->check(CLI::Range(0, 100));
  make->add_option("--seed", o->seed, "of everything random")->check(CLI::NonNegativeNumber)->capture_default_str();
  make->add_option("-j,--jobs", o->jobs, "processes at a time")->check(CLI::Range(1, 64))->capture_default_str();
  make->add_option("--params", o->params_file, "YAML file of parameters")->type_name("FILE");
  make->add_option("--set", o->overrides, "key=value, overrides a parameter; may be repeated");
  make->add_flag("!--no-rawlog", o->rawlog, "recordings without recording.rawlog, which is half of their bytes");
  make->add_flag("--quiet", o->quiet, "no progress");
  make->add_option("--child", o->child)->group("");  // one part of the work, in this process
  make->callback([o, &exit_status] { exit_status = make_dataset(*o); });
}

void add_annotate(CLI::App& dataset, int& exit_status) {
  struct Arguments {
    std::string recording, cloud, out, poses;
  };
  const auto a = std::make_shared<Arguments>();
  CLI::App* annotate = dataset.add_subcommand("annotate", "which point of a reconstruction belongs to which object");
  annotate->add_option("recording", a->recording, "folder of a recording that `make` wrote")
      ->type_name("DIR")
      ->required();
  annotate->add_option("cloud", a->cloud, "PLY or PCD, in the frame of the recording's poses")
      ->type_name("FILE")
      ->required();
  annotate->add_option("--out", a->out, "folder of full rooms in ObChange's layout: a scene more of a room")
      ->type_name("DIR")
      ->required();
  annotate->add_option("--poses", a->poses, "TUM trajectory that the cloud was made with [estimated.txt]")
      ->type_name("FILE");
  annotate->callback([a, &exit_status] {
    std::cout << annotate_cloud(a->recording, a->cloud, a->out, a->poses);
    exit_status = kGoalMet;
  });
}

}  // namespace

void add_dataset_command(CLI::App& app, int& exit_status) {
  CLI::App* dataset = app.add_subcommand("dataset", "recordings for change detection with ground truth");
  dataset->require_subcommand(1);
  add_make(*dataset, exit_status);
  add_annotate(*dataset, exit_status);
}

}  // namespace amiss::app
