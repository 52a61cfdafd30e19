#include "detect_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>

#include "core/result.hpp"
#include "mapping/voxel_files.hpp"
#include "resources.hpp"
#include "semantics_label.hpp"
#include "semantics/forest_labeller.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;

constexpr double kMostClasses = 40.0;  // NYU40
constexpr const char* kLabelField = "label";

std::optional<fs::path> first_there(const fs::path& folder, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (fs::is_regular_file(folder / name)) return folder / name;
  }
  return {};
}

SemanticClass class_of(double value, const fs::path& file, std::size_t point) {
  if (value >= 0.0 && value <= kMostClasses && value == std::floor(value)) return static_cast<SemanticClass>(value);
  throw InputError(
      fmt::format("{}: point {} has the label {}; allowed are the class numbers of NYU40, 0 to 40 (or "
                  "leave the field out with --labels none)",
                  file.string(), point, value));
}

void take_from_field(LoadedScene& loaded, const dataset::ScalarField& field, const fs::path& file) {
  for (const std::uint32_t i : loaded.in_file) loaded.scene.labels.push_back(class_of(field.values[i], file, i));
  const std::string labeller = told_labeller(loaded.file);
  loaded.labels = "field 'label' of " + file.filename().string() + (labeller.empty() ? "" : ", by " + labeller);
}

void take_from_forest(LoadedScene& loaded, const fs::path& model) {
  const semantics::ForestLabeller labeller = semantics::load_forest_labeller(model);
  loaded.scene.labels = labeller.label(loaded.scene.cloud);
  loaded.labels = labeller.identity().to_line();
}

void take_labels(LoadedScene& loaded, const fs::path& file, const LabelSource& source) {
  loaded.labels = "none";
  const dataset::ScalarField* field = loaded.file.field(kLabelField);
  if (source.choice == "cloud" && field == nullptr) {
    throw ArgumentError("--labels cloud: " + file.string() + " has no field 'label'");
  }
  if (source.choice == "cloud" || (source.choice == "auto" && field != nullptr)) {
    take_from_field(loaded, *field, file);
  } else if (source.choice == "forest" || (source.choice == "auto" && fs::exists(source.model()))) {
    take_from_forest(loaded, source.model());
  }
}

}  // namespace

SceneSource scene_source(const fs::path& path) {
  if (fs::is_directory(path)) {
    const auto cloud = first_there(path, {"cloud.ply", "cloud.pcd"});
    if (!cloud) throw InputError(path.string() + ": holds neither cloud.ply nor cloud.pcd");
    return {*cloud, first_there(path, {"space.bt", "space.ot"})};
  }
  const std::string stem = path.stem().string();
  return {path, first_there(path.parent_path(), {stem + "_space.bt", stem + "_space.ot"})};
}

fs::path LabelSource::model() const {
  return forest.empty() ? find_resources().objects.parent_path() / "semantics" / "forest.bin" : forest;
}

const std::vector<std::string>& label_choices() {
  static const std::vector<std::string> kChoices = {"auto", "cloud", "forest", "none"};
  return kChoices;
}

LoadedScene load_scene(const SceneSource& source, const LabelSource& labels) {
  LoadedScene loaded;
  loaded.file = dataset::load_cloud(source.cloud);
  const Cloud<Map>& cloud = loaded.file.cloud();
  for (std::uint32_t i = 0; i < cloud.points.size(); ++i) {
    if (!cloud.points[i].allFinite()) continue;
    loaded.in_file.push_back(i);
    loaded.scene.cloud.points.push_back(cloud.points[i]);
    if (!cloud.colours.empty()) loaded.scene.cloud.colours.push_back(cloud.colours[i]);
  }
  if (loaded.in_file.empty())
    throw InputError(source.cloud.string() + ": has no finite point; a cloud of a room is needed");
  take_labels(loaded, source.cloud, labels);
  loaded.space = "none";
  if (source.space) {
    loaded.scene.space = mapping::load_voxel_map(*source.space);
    loaded.space = source.space->filename().string();
  }
  return loaded;
}

LoadedScenes load_scenes(const SceneSource& reference, const SceneSource& current, const LabelSource& labels) {
  auto second = std::async(std::launch::async, [&] { return load_scene(current, labels); });
  LoadedScene first = load_scene(reference, labels);
  return {std::move(first), second.get()};
}

}  // namespace amiss::app
