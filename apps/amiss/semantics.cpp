// amiss semantics train | label | evaluate: the classes of surfaces (5.2.1).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/result.hpp"
#include "dataset/cloud_files.hpp"
#include "resources.hpp"
#include "semantics/confusion.hpp"
#include "semantics/forest_labeller.hpp"
#include "semantics_label.hpp"
#include "semantics_rooms.hpp"
#include "training/curriculum.hpp"

namespace amiss::app {
namespace {

struct TrainArguments {
  std::string out, params;
  std::vector<std::string> overrides;
  std::uint64_t seed = 1;
  int threads = 2;
  bool quiet = false, print_params = false;
};
struct EvaluateArguments {
  std::string model, confusion, save_clouds;
  std::vector<std::string> rooms;
  std::uint64_t seed = 1;
  int threads = 2;
};

int train(const TrainArguments& arguments) {
  training::CurriculumParams params;
  ParamTable table;
  training::describe(table, params);
  if (!arguments.params.empty()) table.load_file(arguments.params);
  for (const std::string& assignment : arguments.overrides) table.set_override(assignment);
  if (arguments.print_params) {
    std::cout << table.to_yaml();
    return kGoalMet;
  }
  if (arguments.out.empty()) throw ArgumentError("--out FILE: where the forest is written is needed");
  const Resources resources = find_resources();
  const auto catalogue = world::load_catalogue({resources.objects});
  const auto classes = world::load_class_table(resources.worlds / "classes.yaml");
  const semantics::Forest forest =
      training::train(params, catalogue, classes, arguments.seed, arguments.threads, [&](int done) {
        if (!arguments.quiet && done % 10 == 0) std::cerr << fmt::format("amiss: {} of {} rooms\n", done, params.rooms);
      });
  semantics::save_forest(arguments.out, forest);
  if (!arguments.quiet)
    std::cerr << fmt::format("amiss: {} trees, {} classes\n", forest.trees.size(), forest.classes.size());
  return kGoalMet;
}

void print_table(const std::vector<std::pair<std::string, semantics::Confusion>>& columns) {
  std::cout << fmt::format("{:<16}", "IoU");
  for (const auto& [name, confusion] : columns) std::cout << fmt::format("{:>16}", name);
  std::cout << fmt::format("{:>12}\n", "points");
  const semantics::Confusion& all = columns.back().second;
  for (const NamedSemanticClass& c : kSemanticClasses) {
    if (all.total_of(c.value) == 0) continue;
    std::cout << fmt::format("{:<16}", c.name);
    for (const auto& [name, confusion] : columns) {
      const auto iou = confusion.iou(c.value);
      std::cout << (iou && confusion.total_of(c.value) > 0 ? fmt::format("{:>16.3f}", *iou)
                                                           : fmt::format("{:>16}", "-"));
    }
    std::cout << fmt::format("{:>12}\n", all.total_of(c.value));
  }
  std::cout << fmt::format("{:<16}", "mean");
  for (const auto& [name, confusion] : columns) std::cout << fmt::format("{:>16.3f}", confusion.mean_iou());
  std::cout << fmt::format("\n{:<16}", "accuracy");
  for (const auto& [name, confusion] : columns) std::cout << fmt::format("{:>16.3f}", confusion.accuracy());
  std::cout << "\n";
}

void save_labelled(const std::filesystem::path& file, const training::LabelledCloud& sample,
                   const std::vector<SemanticClass>& labels) {
  dataset::CloudFile cloud{{sample.cloud, {}}, {{"label", {}}, {"true_label", {}}}};
  for (const SemanticClass value : labels) cloud.fields[0].values.push_back(static_cast<double>(value));
  for (const SemanticClass value : sample.classes) cloud.fields[1].values.push_back(static_cast<double>(value));
  std::filesystem::create_directories(file.parent_path());
  dataset::save_cloud(file, cloud);
}

int evaluate(const EvaluateArguments& arguments) {
  semantics::ForestLabellerParams params;
  params.threads = arguments.threads;
  const auto labeller = semantics::load_forest_labeller(forest_file(arguments.model), params);
  std::vector<std::pair<std::string, semantics::Confusion>> columns;
  semantics::Confusion all;
  for (const RoomSample& sample : sampled_rooms(arguments.rooms, arguments.seed, arguments.threads)) {
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<SemanticClass> labels = labeller.label(sample.labelled.cloud);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    std::cerr << fmt::format("amiss: {}: {} points labelled in {:.2f} s\n", sample.room, labels.size(), took.count());
    if (!arguments.save_clouds.empty()) {
      save_labelled(std::filesystem::path(arguments.save_clouds) / (sample.room + ".ply"), sample.labelled, labels);
    }
    semantics::Confusion confusion;
    confusion.add(sample.labelled.classes, labels);
    all.add(sample.labelled.classes, labels);
    columns.emplace_back(sample.room, confusion);
  }
  columns.emplace_back("all", all);
  std::cout << "labeller: " << labeller.identity().to_line() << "\n";
  print_table(columns);
  if (!arguments.confusion.empty()) semantics::save_confusion(arguments.confusion, all);
  return kGoalMet;
}

template <class Arguments>
std::shared_ptr<Arguments> with_threads(CLI::App* command) {
  auto arguments = std::make_shared<Arguments>();
  command->add_option("-j,--threads", arguments->threads, "threads; the result is the same")->check(CLI::Range(1, 64));
  return arguments;
}

void add_train(CLI::App* command, int& exit_status) {
  const auto arguments = with_threads<TrainArguments>(command);
  command->add_option("--out", arguments->out, "the forest's file")->type_name("FILE");
  command->add_option("--seed", arguments->seed, "seed of rooms and trees");
  command->add_option("--params", arguments->params, "YAML file with deviations from the defaults")->type_name("FILE");
  command->add_option("--set", arguments->overrides, "KEY=VALUE, one parameter")->take_all();
  command->add_flag("--print-params", arguments->print_params, "print all parameters and stop");
  command->add_flag("--quiet", arguments->quiet, "no progress");
  command->callback([arguments, &exit_status] { exit_status = train(*arguments); });
}

void add_label(CLI::App* command, int& exit_status) {
  const auto arguments = with_threads<LabelArguments>(command);
  command->add_option("CLOUD", arguments->cloud, "reconstruction, 1 cm (.ply, .pcd)")->type_name("FILE")->required();
  command->add_option("--out", arguments->out, "the cloud with a field `label` (NYU40 numbers)")
      ->type_name("FILE")
      ->required();
  command->add_option("--model", arguments->model, "a forest; the one that comes with amiss if nothing is chosen")
      ->type_name("FILE");
  command->add_option("--network", arguments->network, "YAML that describes a 2D network in ONNX, with --recording")
      ->type_name("FILE");
  command->add_option("--recording", arguments->recording, "what CLOUD was made of: images, depth and poses")
      ->type_name("FILE");
  command->add_option("--intrinsics", arguments->intrinsics, "FX,FY,CX,CY of the recording's camera in pixels")
      ->delimiter(',')
      ->expected(4)
      ->check(CLI::Range(0.0, 1e5));
  command->add_option("--depth-scale", arguments->depth_scale, "units of the recording's depth images for a metre")
      ->check(CLI::Range(1.0, 1e6));
  command->add_option("--truth", arguments->truth,
                      "cloud with the true classes as `label`: not learned, for ablations");
  command->add_option("--confusion", arguments->confusion, "TSV of `evaluate --confusion`, with --truth")
      ->type_name("FILE");
  command->add_option("--set", arguments->overrides, "KEY=VALUE: semantics.forest.*, semantics.rendered.*")->take_all();
  command->add_option("--seed", arguments->seed, "of what spoils the true classes");
  command->callback([arguments, &exit_status] {
    label_cloud(*arguments);
    exit_status = kGoalMet;
  });
}

void add_evaluate(CLI::App* command, int& exit_status) {
  const auto arguments = with_threads<EvaluateArguments>(command);
  command->add_option("--model", arguments->model, "a forest; the one that comes with amiss if left out")
      ->type_name("FILE");
  command->add_option("--rooms", arguments->rooms, "rooms of the data set, all if left out")->delimiter(',');
  command->add_option("--seed", arguments->seed, "seed of the objects that lie about and of the noise");
  command->add_option("--confusion", arguments->confusion, "TSV file for the counts of all rooms")->type_name("FILE");
  command->add_option("--save-clouds", arguments->save_clouds, "folder for the labelled clouds")->type_name("DIR");
  command->callback([arguments, &exit_status] { exit_status = evaluate(*arguments); });
}

}  // namespace

void add_semantics_command(CLI::App& app, int& exit_status) {
  CLI::App* const command = app.add_subcommand("semantics", "What surfaces belong to: train, label, evaluate");
  command->require_subcommand(1);
  add_train(command->add_subcommand("train", "Make a forest from rooms that are made up for it"), exit_status);
  add_label(command->add_subcommand("label", "Give every point of a cloud its class"), exit_status);
  add_evaluate(command->add_subcommand("evaluate", "IoU of each class on the five rooms of the data set"), exit_status);
}

}  // namespace amiss::app
