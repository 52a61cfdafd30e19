// Which topics a bag has, and where their messages are, from one reading of it from front to back.
// in: bag     out: topics by what they hold, cameras, the frames that hang on each other. InputError for messages that
// are none of their type.
#pragma once

#include <map>
#include <optional>
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
  std::map<std::string, PlacedTopic> packed;   // CompressedImage of either kind
  std::map<std::string, std::string> cameras;  // a message of each, read where it is needed
  FrameTree frames;
};

[[nodiscard]] BagTopics topics_of(const BagFile& bag, const std::string& name);

/// Of the topic camera_info beside the images, else the only one; nothing where there is none. InputError where it is
/// not calibrated; others need not be.
[[nodiscard]] std::optional<CameraIntrinsics> camera_beside(const BagTopics& topics, const std::string& image_topic,
                                                            const std::string& name);

}  // namespace amiss::dataset
