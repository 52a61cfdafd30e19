// Ground truth for a reconstruction of one of our own recordings: instance and class of each point.
// Cloud in the frame of the recording's map, the recording's folder -> numbers of bodies, and what is written of them:
// the objects for ObChange's .anno, and the cloud with the fields `label` (class number of NYU40) and `instance`.
// Errors: InputError where the folder has no truth/instances.txt (see instance_images.hpp) or that list lacks a frame.
#pragma once

#include <filesystem>
#include <vector>

#include "dataset/annotation_file.hpp"
#include "dataset/cloud_files.hpp"
#include "dataset/instance_images.hpp"

namespace amiss::dataset {

struct GroundTruth {
  std::vector<Instance> instances;      // the table of the recording
  std::vector<std::uint16_t> of_point;  // number of a body for each point, 0 where no frame saw it

  /// The names of the placed objects, with or without points.
  [[nodiscard]] std::vector<std::string> placed() const;
  /// How many points some frame saw.
  [[nodiscard]] std::size_t seen() const;
  /// The placed objects that have points, in the order of the table, with where they lie.
  [[nodiscard]] std::vector<AnnotatedObject> objects() const;
  /// The points with `label` and `instance`.
  [[nodiscard]] CloudFile labelled(const Cloud<Map>& cloud) const;
};

/// Every `every`-th frame votes. `poses`: the trajectory that the cloud was made with, where it is not the recording's.
[[nodiscard]] GroundTruth ground_truth_of(const Cloud<Map>& cloud, const std::filesystem::path& recording,
                                          std::size_t every = 2, const std::filesystem::path& poses = {});

}  // namespace amiss::dataset
