// An MRPT rawlog as a recording of a depth camera, whoever wrote it: its CObservation3DRangeScan and where the camera
// was.
//
// in: rawlog, whole or broken off     out: dataset::Recording: frames in the order of the file; T_map_camera from the
// trajectory that the options name, else from CObservationOdometry ("map" is the odometry's frame), between two that
// are at most 0.5 s apart, and the camera's pose on the robot. Colours are taken into the depth image where the camera
// has two eyes; what the eye for colours does not see is left out. Images count as rectified. Errors: as
// RawlogReader's; InputError where no frame has colour, depth and a pose.
#pragma once

#include <filesystem>
#include <memory>

#include "dataset/recording.hpp"

namespace amiss::recording {

/// By its first bytes: gzipped, or an object of MRPT.
[[nodiscard]] bool is_rawlog(const std::filesystem::path& file);

[[nodiscard]] std::unique_ptr<dataset::Recording> open_rawlog(const std::filesystem::path& file,
                                                              const dataset::RecordingOptions& options = {});

}  // namespace amiss::recording
