// Options that `amiss detect` and `amiss evaluate` share: parameters of detection, and where labels come from.
#pragma once

#include <string>
#include <vector>

#include "change/novel.hpp"
#include "detect_scene.hpp"

namespace CLI {
class App;
}

namespace amiss::app {

struct DetectSettings {
  LabelSource labels;
  change::NovelParams params;

  void add_options(CLI::App& command);
  void load();  // after the command line was read
  [[nodiscard]] std::string as_yaml() const;

 private:
  std::string params_file_;
  std::vector<std::string> overrides_;
};

/// Does the method begin with labels ("semantic", "no-planes")?
[[nodiscard]] bool needs_labels(const std::string& method);
/// ArgumentError when the method needs labels that the scene does not have.
void check_labels(const std::string& method, const LoadedScene& current);

}  // namespace amiss::app
