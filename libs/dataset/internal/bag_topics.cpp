#include "dataset/internal/bag_topics.hpp"

#include <algorithm>

namespace amiss::dataset {
namespace {

/// Images, scans and odometry begin with a header.
void add(std::map<std::string, PlacedTopic>& topics, const std::string& topic, const RosHeader& header,
         const BagPlace& place) {
  PlacedTopic& of_it = topics[topic];
  if (of_it.places.empty()) of_it.frame = header.frame;
  of_it.places.push_back({header.stamp, place});
}

void sort_by_time(std::map<std::string, PlacedTopic>& topics) {
  for (auto& [topic, of_it] : topics) {
    std::stable_sort(of_it.places.begin(), of_it.places.end(),
                     [](const StampedPlace& a, const StampedPlace& b) { return a.stamp < b.stamp; });
  }
}

}  // namespace

BagTopics topics_of(const BagFile& bag, const std::string& name) {
  BagTopics topics;
  bag.each([&](const BagConnection& connection, const BagPlace& place, std::string_view message) {
    const std::string where = name + ", " + connection.topic;
    const auto add_to = [&](std::map<std::string, PlacedTopic>& those) {
      add(those, connection.topic, parse_ros_header(message, where), place);
    };
    if (connection.type == "sensor_msgs/Image") {
      const bool is_known_depth = topics.depths.contains(connection.topic);
      const bool is_known = is_known_depth || topics.colours.contains(connection.topic);
      add_to((is_known ? is_known_depth : is_ros_depth(message, where)) ? topics.depths : topics.colours);
    } else if (connection.type == "sensor_msgs/CompressedImage") {
      add_to(topics.packed);
    } else if (connection.type == "sensor_msgs/LaserScan") {
      add_to(topics.scans);
    } else if (connection.type == "nav_msgs/Odometry") {
      add_to(topics.odometries);
    } else if (connection.type == "sensor_msgs/CameraInfo" && !topics.cameras.contains(connection.topic)) {
      topics.cameras[connection.topic] = message;
    } else if (connection.type == "tf2_msgs/TFMessage" || connection.type == "tf/tfMessage") {
      const bool fixed = connection.topic == "/tf_static";
      for (const RosTransform& one : parse_ros_transforms(message, where)) topics.frames.add(one, fixed);
    }
  });
  for (auto* those : {&topics.depths, &topics.colours, &topics.packed, &topics.scans, &topics.odometries}) {
    sort_by_time(*those);
  }
  return topics;
}

std::optional<CameraIntrinsics> camera_beside(const BagTopics& topics, const std::string& image_topic,
                                              const std::string& name) {
  auto found = topics.cameras.find(image_topic.substr(0, image_topic.rfind('/')) + "/camera_info");
  if (found == topics.cameras.end() && topics.cameras.size() == 1) found = topics.cameras.begin();
  if (found == topics.cameras.end()) return std::nullopt;
  return parse_ros_camera(found->second, name + ", " + found->first);
}

}  // namespace amiss::dataset
