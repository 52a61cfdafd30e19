// A ROS 1 bag as a recording: which topics hold colour, depth and the camera, poses from /tf and /tf_static.
#pragma once

#include <memory>

#include "dataset/recording.hpp"

namespace amiss::dataset {

[[nodiscard]] std::unique_ptr<Recording> open_bag(const std::filesystem::path& file, const RecordingOptions& options);

}  // namespace amiss::dataset
