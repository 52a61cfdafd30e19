// Reconstructions of full rooms with their ground truth, in the layout that ObChange has for chapter 5:
//   ROOM/scene<N>.pcd   ROOM/Annotations/scene<N>_GT.anno   and, beyond ObChange, ROOM/Annotations/scene<N>_labels.pcd
// The cloud is written as it is; class and instance of its points stand apart from it, as they are for scores only. A
// scene in which nothing was placed (the reference) has no .anno.
#pragma once

#include <filesystem>
#include <string>

#include "dataset/ground_truth.hpp"

namespace amiss::dataset {

/// The cloud is written last: a scene without it is none. std::runtime_error when writing fails.
void save_scene(const std::filesystem::path& room, const std::string& scene, const CloudFile& cloud,
                const GroundTruth& truth);

}  // namespace amiss::dataset
