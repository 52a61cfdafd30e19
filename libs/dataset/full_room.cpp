#include "dataset/full_room.hpp"

#include <algorithm>

#include "core/files.hpp"

namespace amiss::dataset {

void save_scene(const std::filesystem::path& room, const std::string& scene, const CloudFile& cloud,
                const GroundTruth& truth) {
  const std::filesystem::path annotations = room / "Annotations";
  std::filesystem::create_directories(annotations);
  const bool anything = std::any_of(truth.instances.begin(), truth.instances.end(),
                                    [](const Instance& instance) { return !instance.kind.empty(); });
  if (anything) save_atomically(annotations / (scene + "_GT.anno"), annotation_bytes(truth.objects()));
  save_cloud(annotations / (scene + "_labels.pcd"), truth.labelled(cloud.cloud()));
  save_cloud(room / (scene + ".pcd"), cloud);
}

}  // namespace amiss::dataset
