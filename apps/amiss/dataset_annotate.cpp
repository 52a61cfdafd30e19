#include "dataset_annotate.hpp"

#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "core/result.hpp"
#include "dataset/full_room.hpp"

namespace amiss::app {

namespace {

struct Scene {
  std::string room, name;
};

Scene scene_of(const std::filesystem::path& recording) {
  const std::filesystem::path file = recording / "recording.json";
  try {
    const auto json = nlohmann::json::parse(load_bytes(file));
    Scene scene{json.at("room").get<std::string>(), json.at("scene").get<std::string>()};
    const auto is_name = [](const std::string& s) {
      return !s.empty() && s.front() != '.' && s.find('/') == std::string::npos;
    };
    if (is_name(scene.room) && is_name(scene.name)) return scene;
  } catch (const nlohmann::json::exception&) {
  }
  throw InputError(file.string() + ": 'room' and 'scene' are needed, names of a folder and a file");
}

}  // namespace

void annotate_cloud(const std::filesystem::path& recording, const std::filesystem::path& cloud,
                    const std::filesystem::path& rooms, const std::filesystem::path& poses) {
  const Scene scene = scene_of(recording);
  const dataset::CloudFile file = dataset::load_cloud(cloud);
  constexpr std::size_t kEvery = 2;
  const dataset::GroundTruth truth = dataset::ground_truth_of(file.cloud(), recording, kEvery, poses);
  // What the reconstruction saw stands beside its cloud, and stays so.
  if (const std::filesystem::path space = cloud.parent_path() / "space.bt"; std::filesystem::exists(space)) {
    std::filesystem::create_directories(rooms / scene.room);
    save_atomically(rooms / scene.room / (scene.name + "_space.bt"), load_bytes(space));
  }
  dataset::save_scene(rooms / scene.room, scene.name, file, truth);
}

}  // namespace amiss::app
