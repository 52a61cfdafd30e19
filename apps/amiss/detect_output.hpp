// What a detection leaves: a cloud in which the objects are painted, objects.json, a picture.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "change/novel.hpp"
#include "detect_scene.hpp"

namespace amiss::app {

/// The points of each object by their indices in the cloud's file.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> points_in_file(const change::Detection& detection,
                                                                     const LoadedScene& current);

/// The file's cloud with the objects in pink and the field `object`: 0, or the object's number from 1.
[[nodiscard]] dataset::CloudFile painted(const LoadedScene& current,
                                         const std::vector<std::vector<std::uint32_t>>& objects);

/// Objects, and every decision beside the limits that it was held against.
[[nodiscard]] nlohmann::ordered_json objects_json(const change::Detection& detection,
                                                  const change::NovelParams& params);

/// The room from above, the objects in pink with their numbers.
[[nodiscard]] std::string picture_of(const LoadedScene& current,
                                     const std::vector<std::vector<std::uint32_t>>& objects);

}  // namespace amiss::app
