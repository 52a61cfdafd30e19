#include "trial_basis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/files.hpp"
#include "interrupt.hpp"
#include "reference_cache.hpp"
#include "resources.hpp"
#include "start_pose.hpp"
#include "world/fingerprint.hpp"
#include "world/loader.hpp"

namespace amiss::app {

namespace fs = std::filesystem;

namespace {

std::string hash_of_folder(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::string all;
  for (const fs::path& file : files) {
    all += fmt::format("{} {}\n", fs::relative(file, folder).string(), sha256(load_bytes(file)));
  }
  return sha256(all);
}

Settings settings_of(const experiment::Spec& spec) {
  std::vector<std::string> overrides;
  for (const auto& [key, value] : spec.params) overrides.push_back(key + "=" + value);
  return load_settings("", overrides);
}

/// Calls `use` with what a mapping run of this world would start from.
template <class Use>
auto with_mapping_input(const std::string& name, const Settings& settings, const Resources& resources, const Use& use) {
  const world::World world = world::load_world(find_world(resources, name), settings.world);
  const robot::Model model = robot::load_model(resources.robot);
  return use(MappingInput{world, model, start_pose(world, model, {}), resources.robot});
}

}  // namespace

std::map<std::string, std::string> trial_keys(const experiment::Spec& spec) {
  const Resources resources = find_resources();
  Settings settings = settings_of(spec);
  const std::string shared =
      fmt::format("{}\n{}\n{}\n{}\n{}\n", AMISS_VERSION, sha256(load_bytes(resources.robot)),
                  hash_of_folder(resources.objects), hash_of_folder(resources.pddl), settings.table().to_yaml());
  std::map<std::string, std::string> keys;
  for (const std::string& name : spec.worlds) {
    keys[name] = with_mapping_input(name, settings, resources, [&](const MappingInput& input) {
      return shared + world::fingerprint(input.world) + "\n" + reference_id(input, settings);
    });
  }
  return keys;
}

bool prepare_references(const experiment::Spec& spec, const std::function<void(const std::string&)>& announce) {
  const Resources resources = find_resources();
  Settings settings = settings_of(spec);
  mission::Sinks sinks;
  sinks.stop = interrupted;
  return std::all_of(spec.worlds.begin(), spec.worlds.end(), [&](const std::string& name) {
    return with_mapping_input(name, settings, resources, [&](const MappingInput& input) {
      return cached_reference(input, settings, true, sinks, [&] { announce(name); }).has_value();
    });
  });
}

}  // namespace amiss::app
