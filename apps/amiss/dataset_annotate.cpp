#include "dataset_annotate.hpp"

#include "core/files.hpp"
#include "dataset/ground_truth.hpp"

namespace amiss::app {

void annotate_cloud(const std::filesystem::path& recording, const std::filesystem::path& cloud,
                    const std::filesystem::path& out) {
  const dataset::CloudFile file = dataset::load_cloud(cloud);
  const dataset::GroundTruth truth = dataset::ground_truth_of(file.cloud(), recording);
  if (out.has_parent_path()) std::filesystem::create_directories(out.parent_path());
  save_atomically(out, dataset::annotation_bytes(truth.objects()));
  std::filesystem::path labels = out;
  dataset::save_cloud(labels.replace_extension(".pcd"), truth.labelled(file.cloud()));
}

}  // namespace amiss::app
