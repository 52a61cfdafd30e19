// Which files of a folder are the reconstructions of rooms, their annotations and their seen space: ObChange's layout
// of full rooms (chapter 5), as others have it on disk.
//   DATASET/<room>/scene<N>.pcd or .ply            N = 1 is the reference
//   DATASET/<room>/Annotations/scene<N>_GT.anno    also beside the cloud, or in DATASET/Annotations/<room>/
//   DATASET/<room>/scene<N>_space.bt or .ot        beyond ObChange: the space that was seen, where somebody has it
// in: the data set, or the folder of one room. out: rooms by name, scenes by number. Upper and lower case are the same;
// whatever else lies there is left alone; where a scene is there as .pcd and as .ply the .pcd counts.
// Errors: InputError when the folder cannot be read or no room is in it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace amiss::dataset {

struct SceneFiles {
  int number = 0;
  std::filesystem::path cloud;
  std::optional<std::filesystem::path> annotations, space;

  [[nodiscard]] std::string name() const { return "scene" + std::to_string(number); }
};

struct RoomFolder {
  std::string name;
  std::vector<SceneFiles> scenes;  // by number

  [[nodiscard]] const SceneFiles* scene(int number) const;  // nullptr where there is none
};

[[nodiscard]] std::vector<RoomFolder> room_folders(const std::filesystem::path& folder);

/// Are there scenes right in this folder?
[[nodiscard]] bool is_room_folder(const std::filesystem::path& folder);

}  // namespace amiss::dataset
