// amiss completion, amiss man: made from the same declarations as --help.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "completion.hpp"
#include "core/result.hpp"
#include "man_page.hpp"
#include "resources.hpp"
#include "settings.hpp"

namespace amiss::app {

namespace {

std::string worlds() {
  std::string lines;
  for (const std::string& name : world_names(find_resources())) lines += name + "\n";
  return lines;
}

std::string parameters() {
  Settings settings;
  const ParamTable table = settings.table();
  std::string lines;
  for (const ParamTable::Row& row : table.rows()) lines += row.key + "\n";
  return lines;
}

/// A script, or the words that a script asks for.
std::string completion(const std::string& what, const CLI::App& app) {
  if (what == "bash") return bash_completion(command_tree(app));
  if (what == "zsh") return zsh_completion(command_tree(app));
  if (what == "worlds") return worlds();
  if (what == "parameters") return parameters();
  throw ArgumentError("completion " + what + ": there are scripts for bash and zsh");
}

}  // namespace

void add_completion_command(CLI::App& app, int&) {
  const auto what = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("completion", "a completion script for a shell: `source <(amiss completion bash)`");
  command->add_option("SHELL", *what, "whose script")->type_name("TEXT:{bash,zsh}")->required();
  command->callback([what, &app] { std::cout << completion(*what, app); });
}

void add_man_command(CLI::App& app, int&) {
  app.add_subcommand("man", "the manual as a man page: `amiss man | man -l -`")->callback([&app] {
    Settings settings;
    std::cout << man_page(command_tree(app), settings.table(), AMISS_VERSION);
  });
}

}  // namespace amiss::app
