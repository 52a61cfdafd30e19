// Ground truth for a reconstruction that somebody made of one of our recordings.
#pragma once

#include <filesystem>
#include <string>

namespace amiss::app {

/// Recording's folder, cloud (PLY or PCD) -> a scene more in the folder of full rooms (dataset/full_room.hpp). `poses`:
/// the trajectory that the cloud was made with, where it is not the recording's. Returns what to tell people: how many
/// of the placed objects have points, and which have none. InputError where the recording has no ground truth or does
/// not say of what it is, and for a cloud that has nothing to do with it.
[[nodiscard]] std::string annotate_cloud(const std::filesystem::path& recording, const std::filesystem::path& cloud,
                                         const std::filesystem::path& rooms, const std::filesystem::path& poses = {});

}  // namespace amiss::app
