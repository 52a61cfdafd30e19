// Which topics a bag has, and where their messages are, from one reading of it from front to back.
// in: bag     out: topics by what they hold, cameras, the frames that hang on each other. InputError for messages that
// are none of their type.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "dataset/internal/bag_file.hpp"
#include "dataset/internal/frame_tree.hpp"

namespace amiss::dataset {

struct StampedPlace {
  Stamp stamp;
  BagPlace place;
};
struct PlacedTopic {
  std::string frame;                 // of the first message
  std::vector<StampedPlace> places;  // by time
};
struct BagTopics {
  std::map<std::string, PlacedTopic> depths, colours, scans, odometries;
  std::map<std::string, PlacedTopic> packed;  // CompressedImage of either kind
  std::map<std::string, CameraIntrinsics> cameras;
  FrameTree frames;
};

[[nodiscard]] BagTopics topics_of(const BagFile& bag, const std::string& name);

/// Of the topic camera_info beside the images, else the only one; nothing where there is none.
[[nodiscard]] const CameraIntrinsics* camera_beside(const std::map<std::string, CameraIntrinsics>& cameras,
                                                    const std::string& image_topic);

}  // namespace amiss::dataset
