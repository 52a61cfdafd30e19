// A reconstruction for detection: its points, what each belongs to, and the space that was seen, each with where it
// comes from. File -> change::Scene; points that are not finite stay in the file and are left out of the scene.
// Errors: InputError for files that cannot be read or labels that are no classes; ArgumentError where labels are asked
// for that are not there.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "change/novel.hpp"
#include "dataset/cloud_files.hpp"

namespace amiss::app {

/// A cloud and, where there is one, the voxel map of the seen space beside it.
struct SceneSource {
  std::filesystem::path cloud;
  std::optional<std::filesystem::path> space;
};

/// A cloud, or a folder that `amiss reconstruct` wrote (cloud.ply, space.bt). Beside NAME.ply the space is
/// NAME_space.bt or NAME_space.ot.
[[nodiscard]] SceneSource scene_source(const std::filesystem::path& path);

/// Where the labels of a reconstruction come from.
struct LabelSource {
  std::string choice = "auto";   // of label_choices()
  std::filesystem::path forest;  // a model of the labeller `forest`; empty: that of the program, where it has one

  [[nodiscard]] std::filesystem::path model() const;
};
/// "auto": the cloud's field `label` where it is there, else the forest where there is a model; "cloud": that field, it
/// must be there; "forest": the cloud's own labels do not count; "none".
[[nodiscard]] const std::vector<std::string>& label_choices();

struct LoadedScene {
  dataset::CloudFile file;
  change::Scene scene;
  std::vector<std::uint32_t> in_file;  // for each point of the scene
  std::string labels, space;           // where they come from, for reports; "none"
};
[[nodiscard]] LoadedScene load_scene(const SceneSource& source, const LabelSource& labels);

struct LoadedScenes {
  LoadedScene reference, current;
};
/// Both at a time; where both cannot be read, the error is the reference's.
[[nodiscard]] LoadedScenes load_scenes(const SceneSource& reference, const SceneSource& current,
                                       const LabelSource& labels);

}  // namespace amiss::app
