// amiss init DIR: a world, a scenario and all parameters, to begin with.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/result.hpp"
#include "resources.hpp"
#include "settings.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;

void run(const fs::path& folder) {
  if (fs::exists(folder) && !(fs::is_directory(folder) && fs::is_empty(folder))) {
    throw ArgumentError(folder.string() + " is there already and holds something; a new or an empty folder is needed");
  }
  const fs::path templates = find_resources().init;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder.string() + ": cannot be made: " + error.message());
  for (const char* name : {"room.sdf", "scenario.yaml", "README.md"}) {
    save_atomically(folder / name, load_bytes(templates / name));
  }
  Settings settings;
  save_atomically(folder / "params.yaml", settings.table().to_yaml());
  std::cout << "made " << folder.string() << ": room.sdf, scenario.yaml, params.yaml, README.md\n"
            << "try: cd " << folder.string() << " && amiss tidy --world room.sdf --params params.yaml\n";
}

}  // namespace

void add_init_command(CLI::App& app, int&) {
  const auto folder = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("init", "a folder with a world, a scenario and all parameters to begin with");
  command->add_option("DIR", *folder, "a new or an empty folder")->type_name("DIR")->required();
  command->callback([folder] { run(*folder); });
}

}  // namespace amiss::app
