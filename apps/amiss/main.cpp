#include <CLI/CLI.hpp>
#include <iostream>

#include "command_tree.hpp"
#include "commands.hpp"
#include "core/result.hpp"
#include "wrong_arguments.hpp"

namespace {

using namespace amiss::app;

Refusal refusal_of(const CLI::ParseError& e) {
  using Code = CLI::ExitCodes;  // the name of an error is sometimes that of a command
  const auto code = static_cast<Code>(e.get_exit_code());
  if (code == Code::RequiredError || code == Code::ExtrasError) return {Refusal::Kind::kWord, e.what()};
  return {code == Code::ValidationError ? Refusal::Kind::kValue : Refusal::Kind::kOther, e.what()};
}

int run(int argc, char** argv) {
  CLI::App app("A simulated robot finds what lies where it did not lie before.", "amiss");
  app.set_version_flag("--version", "amiss " AMISS_VERSION);
  app.require_subcommand(1);
  int exit_status = kGoalMet;
  add_tidy_command(app, exit_status);
  add_experiment_command(app, exit_status);
  add_dataset_command(app, exit_status);
  add_map_command(app, exit_status);
  add_diff_command(app, exit_status);
  add_detect_command(app, exit_status);
  add_evaluate_command(app, exit_status);
  add_plan_command(app, exit_status);
  add_reconstruct_command(app, exit_status);
  add_scenario_command(app, exit_status);
  add_semantics_command(app, exit_status);
  add_view_command(app, exit_status);
  add_video_command(app, exit_status);
  add_scene_command(app, exit_status);
  add_replay_command(app, exit_status);
  add_worlds_command(app, exit_status);
  add_objects_command(app, exit_status);
  add_init_command(app, exit_status);
  add_doctor_command(app, exit_status);
  add_completion_command(app, exit_status);
  add_man_command(app, exit_status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& e) {
    std::cerr << "amiss: " << explain(command_tree(app), {argv + 1, argv + argc}, refusal_of(e)) << "\n";
    return kWrongArguments;
  }
  return exit_status;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const amiss::ArgumentError& e) {
    std::cerr << "amiss: " << e.what() << "\n";
    return kWrongArguments;
  } catch (const amiss::InputError& e) {
    std::cerr << "amiss: " << e.what() << "\n";
    return kUnreadableInput;
  } catch (const std::exception& e) {
    std::cerr << "amiss: " << e.what() << "\n";
    return kUnreadableInput;
  }
}
