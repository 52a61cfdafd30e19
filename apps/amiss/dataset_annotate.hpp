// Ground truth for a reconstruction that somebody made of one of our recordings.
#pragma once

#include <filesystem>

namespace amiss::app {

/// CLOUD (PLY or PCD, in the frame of the recording's poses) -> OUT, an .anno file of its points, and OUT with the ending
/// .pcd: the points with label and instance. InputError where the recording has no ground truth.
void annotate_cloud(const std::filesystem::path& recording, const std::filesystem::path& cloud,
                    const std::filesystem::path& out);

}  // namespace amiss::app
