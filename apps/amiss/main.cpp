#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "command_tree.hpp"
#include "commands.hpp"
#include "core/params.hpp"
#include "core/result.hpp"

namespace {

using namespace amiss::app;

/// The nearest of what is declared to the first word that is not.
std::string hint(const CLI::App& app, int argc, char** argv) {
  Command here = command_tree(app);
  for (int i = 1; i < argc; ++i) {
    std::string word(argv[i]);
    std::vector<std::string> known;
    if (word.starts_with("--")) {
      word = word.substr(0, word.find('='));
      for (const CommandOption& option : here.options)
        known.insert(known.end(), option.names.begin(), option.names.end());
    } else if (!here.subcommands.empty()) {
      for (const Command& sub : here.subcommands) known.push_back(sub.name);
    }
    if (known.empty()) continue;
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end()) {
      const std::string near = amiss::nearest_word(word, known);
      return near.empty() ? std::string() : "; did you mean '" + near + "'?";
    }
    if (word.starts_with("--")) continue;
    here = Command(here.subcommands[static_cast<std::size_t>(found - known.begin())]);
  }
  return {};
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
    std::cerr << "amiss: " << e.what() << hint(app, argc, argv) << "\n";
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
