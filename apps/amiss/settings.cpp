#include "settings.hpp"

#include <algorithm>
#include <array>

namespace amiss::app {

namespace {

// What the mapping run does not look at.
constexpr std::array<std::string_view, 7> kOfTheSearch{"search.",  "change.",  "knowledge.", "segment.",
                                                       "referee.", "scatter.", "view_pose."};

}  // namespace

ParamTable Settings::table() {
  ParamTable table;
  mission::describe(table, mission);
  sim::describe(table, simulator);
  sim::describe(table, scatter);
  score::describe(table, referee);
  world::describe(table, world);
  return table;
}

std::string Settings::reference_key() {
  std::string key;
  const ParamTable all = table();
  for (const ParamTable::Row& row : all.rows()) {
    const bool of_the_search = std::any_of(kOfTheSearch.begin(), kOfTheSearch.end(),
                                           [&](std::string_view prefix) { return row.key.starts_with(prefix); });
    if (!of_the_search) key += row.key + "=" + row.print() + "\n";
  }
  return key;
}

Settings load_settings(const std::string& params_file, const std::vector<std::string>& overrides) {
  Settings settings;
  ParamTable table = settings.table();
  if (!params_file.empty()) table.load_file(params_file);
  for (const std::string& assignment : overrides) table.set_override(assignment);
  return settings;  // NRVO or copy: the table is not used any more
}

}  // namespace amiss::app
