#include "dataset_annotate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "core/result.hpp"
#include "dataset/full_room.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;

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

/// A cloud of another room or in another frame: no object has points, and the frames saw next to nothing where it lies.
void check_it_is_of(const dataset::GroundTruth& truth, const fs::path& cloud, const fs::path& recording) {
  constexpr double kLeastSeen = 0.05;
  const auto points = static_cast<double>(truth.of_point.size());
  if (!truth.objects().empty() || static_cast<double>(truth.seen()) > kLeastSeen * points) return;
  throw InputError(
      fmt::format("{}: {} of its {} points lie where a frame of {} saw something; a cloud that was made of "
                  "this recording, in the frame of its poses, is needed",
                  cloud.string(), truth.seen(), truth.of_point.size(), recording.string()));
}

std::string summary_of(const dataset::GroundTruth& truth) {
  const auto objects = truth.objects();
  std::vector<std::string> without;
  for (const std::string& name : truth.placed()) {
    const auto has_points = [&](const dataset::AnnotatedObject& object) { return object.name == name; };
    if (std::none_of(objects.begin(), objects.end(), has_points)) without.push_back(name);
  }
  const std::size_t placed = truth.placed().size();
  if (placed == 0) return "no objects were placed: a reference\n";
  return fmt::format("{} of {} placed objects have points{}{}\n", placed - without.size(), placed,
                     without.empty() ? "" : "; without: ", fmt::join(without, ", "));
}

}  // namespace

std::string annotate_cloud(const std::filesystem::path& recording, const std::filesystem::path& cloud,
                           const std::filesystem::path& rooms, const std::filesystem::path& poses) {
  const Scene scene = scene_of(recording);
  const dataset::CloudFile file = dataset::load_cloud(cloud);
  constexpr std::size_t kEvery = 2;
  const dataset::GroundTruth truth = dataset::ground_truth_of(file.cloud(), recording, kEvery, poses);
  check_it_is_of(truth, cloud, recording);
  // What the reconstruction saw stands beside its cloud, and stays so.
  if (const std::filesystem::path space = cloud.parent_path() / "space.bt"; std::filesystem::exists(space)) {
    std::filesystem::create_directories(rooms / scene.room);
    save_atomically(rooms / scene.room / (scene.name + "_space.bt"), load_bytes(space));
  }
  dataset::save_scene(rooms / scene.room, scene.name, file, truth);
  return summary_of(truth);
}

}  // namespace amiss::app
