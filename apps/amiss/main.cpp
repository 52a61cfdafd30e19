#include <CLI/CLI.hpp>
#include <iostream>

#include "commands.hpp"
#include "core/params.hpp"
#include "core/result.hpp"

namespace {

using namespace amiss::app;

/// CLI11 lists what is missing; a mistyped subcommand gets the nearest one as well.
std::string hint(const CLI::App& app, int argc, char** argv) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(sub->get_name());
  for (int i = 1; i < argc; ++i) {
    const std::string_view word(argv[i]);
    if (word.starts_with('-')) continue;
    if (std::find(names.begin(), names.end(), word) != names.end()) return "";
    const std::string near = amiss::nearest_word(word, names);
    return near.empty() ? std::string() : "; did you mean '" + near + "'?";
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
  add_plan_command(app, exit_status);
  add_scenario_command(app, exit_status);
  add_view_command(app, exit_status);
  add_worlds_command(app, exit_status);
  add_objects_command(app, exit_status);
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
