#include "detect_settings.hpp"

#include <CLI/CLI.hpp>

#include "core/result.hpp"

namespace amiss::app {

void DetectSettings::add_options(CLI::App& command) {
  command
      .add_option(
          "--labels", labels.choice,
          "auto: the cloud's field 'label', else the forest; cloud; forest; none: all surfaces may carry things")
      ->check(CLI::IsMember(label_choices()))
      ->capture_default_str();
  command.add_option("--forest", labels.forest, "model of the forest [the program's own]")->check(CLI::ExistingFile);
  command.add_option("--params", params_file_, "YAML file of parameters")->type_name("FILE");
  command.add_option("--set", overrides_, "key=value, overrides a parameter; may be repeated");
}

void DetectSettings::load() {
  ParamTable table;
  change::describe(table, params);
  if (!params_file_.empty()) table.load_file(params_file_);
  for (const std::string& assignment : overrides_) table.set_override(assignment);
}

std::string DetectSettings::as_yaml() const {
  change::NovelParams copy = params;
  ParamTable table;
  change::describe(table, copy);
  return table.to_yaml();
}

bool needs_labels(const std::string& method) { return method == "semantic" || method == "no-planes"; }

void check_labels(const std::string& method, const LoadedScene& current) {
  if (!needs_labels(method) || !current.scene.labels.empty()) return;
  throw ArgumentError("--method " + method + " begins with semantic labels, and the current cloud has none (--labels)");
}

}  // namespace amiss::app
