// Models by what they are called: objects, furniture and people that come with amiss.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "resources.hpp"
#include "world/loader.hpp"

namespace amiss::app {

/// Names of the models in a folder, sorted.
[[nodiscard]] std::vector<std::string> models_in(const std::filesystem::path& folder);

/// The bodies of these kinds, objects movable; a kind that does not come with amiss is left out.
[[nodiscard]] std::map<std::string, world::Body> load_kinds(const Resources& resources,
                                                            const std::set<std::string>& kinds,
                                                            const world::LoadOptions& options);

}  // namespace amiss::app
