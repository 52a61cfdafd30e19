// amiss diff REFERENCE CURRENT: regions of interest between two OctoMap files.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "change/difference.hpp"
#include "change/region.hpp"
#include "commands.hpp"
#include "mapping/floor_grid_files.hpp"
#include "mapping/voxel_files.hpp"

namespace amiss::app {
namespace {

struct Arguments {
  std::string reference, current, grid;
  int dilate = 0;
  bool json = false;
};

struct Result {
  double resolution_m = 0.0;
  change::Difference difference;
  std::vector<change::Region> regions;
};

Result compare(const Arguments& arguments) {
  const mapping::VoxelMap reference = mapping::load_voxel_map(arguments.reference);
  const mapping::VoxelMap current = mapping::load_voxel_map(arguments.current);
  std::optional<FloorGrid> grid;
  if (!arguments.grid.empty()) grid = mapping::load_floor_grid(arguments.grid);
  change::DifferenceParams params;
  params.reference_dilation_voxels = arguments.dilate;
  change::Differencer differencer(mapping::dilated(reference, arguments.dilate), grid, params);
  change::RegionParams filters;
  filters.min_hit_frames = 0;  // files do not tell how often a voxel was hit
  Result result{reference.resolution_m(), differencer.update(current), {}};
  result.regions = change::regions(result.difference.appeared, current, filters);
  return result;
}

void print_json(const Arguments& arguments, const Result& result) {
  nlohmann::json regions = nlohmann::json::array();
  for (const change::Region& r : result.regions) {
    regions.push_back({{"centre_m", {r.centre_m.x(), r.centre_m.y()}},
                       {"radius_m", r.radius_m},
                       {"z_low_m", r.z_low_m},
                       {"z_high_m", r.z_high_m},
                       {"voxels", r.voxels.size()}});
  }
  const nlohmann::json report = {{"schema", "amiss.diff.1"},
                                 {"reference", arguments.reference},
                                 {"current", arguments.current},
                                 {"resolution_m", result.resolution_m},
                                 {"appeared_voxels", result.difference.appeared.size()},
                                 {"vanished_voxels", result.difference.vanished.size()},
                                 {"unseen_voxels", result.difference.unseen},
                                 {"regions", regions}};
  std::cout << report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

void print_table(const Result& result) {
  std::cout << fmt::format("{:>9}{:>9}{:>11}{:>9}{:>10}{:>8}\n", "x [m]", "y [m]", "radius [m]", "low [m]", "high [m]",
                           "voxels");
  for (const change::Region& r : result.regions) {
    std::cout << fmt::format("{:>9.3f}{:>9.3f}{:>11.3f}{:>9.3f}{:>10.3f}{:>8}\n", r.centre_m.x(), r.centre_m.y(),
                             r.radius_m, r.z_low_m, r.z_high_m, r.voxels.size());
  }
  std::cout << fmt::format("{} regions; voxels: {} appeared, {} vanished, {} unseen\n", result.regions.size(),
                           result.difference.appeared.size(), result.difference.vanished.size(),
                           result.difference.unseen);
}

}  // namespace

void add_diff_command(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* const command = app.add_subcommand("diff", "Regions of interest between two OctoMap files");
  command->add_option("REFERENCE", arguments->reference, "OctoMap of how it was (.ot, .bt)")
      ->type_name("FILE")
      ->required();
  command->add_option("CURRENT", arguments->current, "OctoMap of how it is now (.ot, .bt)")
      ->type_name("FILE")
      ->required();
  command->add_option("--grid", arguments->grid, "map.yaml of the floor; voxels over its obstacles are dropped")
      ->type_name("FILE");
  command->add_option("--dilate", arguments->dilate, "grow the reference by so many voxels in x and y")
      ->check(CLI::Range(0, 5));
  command->add_flag("--json", arguments->json, "print JSON on standard output");
  command->callback([arguments, &exit_status] {
    const Result result = compare(*arguments);
    if (arguments->json) {
      print_json(*arguments, result);
    } else {
      print_table(result);
    }
    exit_status = kGoalMet;
  });
}

}  // namespace amiss::app
