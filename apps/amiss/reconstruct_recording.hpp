// A recording of a user, whatever its format: folders and bags, which `dataset` reads, and rawlogs, which `recording`
// does. InputError where it is none of them; ArgumentError for poses that belong to another kind of recording.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "dataset/recording.hpp"

namespace amiss::app {

[[nodiscard]] std::unique_ptr<dataset::Recording> open_any_recording(const std::filesystem::path& path,
                                                                     const dataset::RecordingOptions& options);

/// FX, FY, CX, CY of an option; nothing where it was not given. The size is that of the images.
[[nodiscard]] std::optional<CameraIntrinsics> intrinsics_of(const std::vector<double>& given);

}  // namespace amiss::app
