// amiss completion, amiss man: made from the same declarations as --help.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "completion.hpp"
#include "man_page.hpp"
#include "resources.hpp"
#include "settings.hpp"

namespace amiss::app {

void add_completion_command(CLI::App& app, int&) {
  const auto what = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("completion", "a completion script for a shell: `source <(amiss completion bash)`");
  command->add_option("WHAT", *what, "a script, or the words that it asks for")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "worlds", "parameters"}));
  command->callback([what, &app] {
    if (*what == "bash") std::cout << bash_completion(command_tree(app));
    if (*what == "zsh") std::cout << zsh_completion(command_tree(app));
    if (*what == "worlds") {
      for (const std::string& name : world_names(find_resources())) std::cout << name << "\n";
    }
    if (*what == "parameters") {
      Settings settings;
      const ParamTable table = settings.table();
      for (const ParamTable::Row& row : table.rows()) std::cout << row.key << "\n";
    }
  });
}

void add_man_command(CLI::App& app, int&) {
  app.add_subcommand("man", "the manual as a man page: `amiss man | man -l -`")->callback([&app] {
    Settings settings;
    std::cout << man_page(command_tree(app), settings.table(), AMISS_VERSION);
  });
}

}  // namespace amiss::app
