#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "commands.hpp"
#include "resources.hpp"
#include "world/catalogue.hpp"
#include "world/loader.hpp"

namespace amiss::app {

void add_worlds_command(CLI::App& app, int&) {
  app.add_subcommand("worlds", "the worlds that come with amiss")->callback([] {
    const Resources resources = find_resources();
    for (const std::string& name : world_names(resources)) {
      const world::World world = world::load_world(find_world(resources, name));
      std::cout << fmt::format("{:<16}{:>4} bodies   {}\n", name, world.bodies.size(), world.file.string());
    }
  });
}

void add_objects_command(CLI::App& app, int&) {
  app.add_subcommand("objects", "the objects that can be scattered")->callback([] {
    std::cout << fmt::format("{:<22}{:<26}{:>20}{:>10}\n", "name", "label", "size [m]", "mass [kg]");
    for (const world::CatalogueEntry& e : world::load_catalogue({find_resources().objects}).entries) {
      const std::string size = fmt::format("{:.3f} {:.3f} {:.3f}", e.size_m.x(), e.size_m.y(), e.size_m.z());
      std::cout << fmt::format("{:<22}{:<26}{:>20}{:>10.3f}\n", e.name, e.label, size, e.body.mass_kg);
    }
  });
}

}  // namespace amiss::app
