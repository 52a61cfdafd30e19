#include "dataset/internal/bag_recording.hpp"

#include <algorithm>

#include "core/result.hpp"
#include "dataset/camera_file.hpp"
#include "dataset/internal/bag_file.hpp"
#include "dataset/internal/folder_index.hpp"
#include "dataset/internal/frame_tree.hpp"
#include "dataset/internal/ros_messages.hpp"

namespace amiss::dataset {
namespace {

namespace fs = std::filesystem;

constexpr double kMillimetres = 1000.0;

struct StampedPlace {
  Stamp stamp;
  BagPlace place;
};
struct ImageTopic {
  bool depth = false;
  std::string frame;
  std::vector<StampedPlace> images;
};
struct Contents {
  std::map<std::string, ImageTopic> images;
  std::map<std::string, CameraIntrinsics> cameras;
  FrameTree frames;
};

Contents contents_of(const BagFile& bag, const std::string& name) {
  Contents contents;
  bag.each([&](const BagConnection& connection, const BagPlace& place, std::string_view message) {
    const std::string where = name + ", " + connection.topic;
    if (connection.type == "sensor_msgs/Image") {
      const RosHeader header = parse_ros_header(message, where);
      ImageTopic& topic = contents.images[connection.topic];
      if (topic.images.empty()) {
        topic.depth = is_ros_depth(message, where);
        topic.frame = header.frame;
      }
      topic.images.push_back({header.stamp, place});
    } else if (connection.type == "sensor_msgs/CameraInfo" && !contents.cameras.contains(connection.topic)) {
      contents.cameras[connection.topic] = parse_ros_camera(message, where);
    } else if (connection.type == "tf2_msgs/TFMessage" || connection.type == "tf/tfMessage") {
      const bool fixed = connection.topic == "/tf_static";
      for (const RosTransform& one : parse_ros_transforms(message, where)) contents.frames.add(one, fixed);
    }
  });
  for (auto& [topic, images] : contents.images) {
    std::stable_sort(images.images.begin(), images.images.end(),
                     [](const StampedPlace& a, const StampedPlace& b) { return a.stamp < b.stamp; });
  }
  return contents;
}

/// The topic that is named, else the HSR's, else the only one of its kind.
const std::pair<const std::string, ImageTopic>& topic_of(const Contents& contents, bool depth, const std::string& wanted,
                                                         const std::string& name) {
  const char* usual = depth ? "/hsrb/head_rgbd_sensor/depth_registered/image_rect_raw"
                            : "/hsrb/head_rgbd_sensor/rgb/image_rect_color";
  const char* what = depth ? "depth (16UC1, mono16, 32FC1)" : "colour";
  std::string there;
  const std::pair<const std::string, ImageTopic>* only = nullptr;
  for (const auto& one : contents.images) {
    if (one.second.depth != depth) continue;
    if (one.first == wanted || (wanted.empty() && one.first == usual)) return one;
    there += (there.empty() ? "" : ", ") + one.first;
    only = only == nullptr && there == one.first ? &one : nullptr;
  }
  if (wanted.empty() && only != nullptr) return *only;
  if (there.empty()) throw InputError(name + ": has no images of " + what);
  throw InputError(name + ": " + (wanted.empty() ? "has several topics" : "has no topic '" + wanted + "'") + " of " +
                   what + "; there are: " + there);
}

/// Of the topic camera_info beside the images.
CameraIntrinsics camera_of(const Contents& contents, const std::string& depth_topic, const RecordingOptions& options,
                           const std::string& name) {
  if (options.intrinsics) return *options.intrinsics;
  const std::string beside = depth_topic.substr(0, depth_topic.rfind('/')) + "/camera_info";
  const auto found = contents.cameras.find(beside);
  if (found != contents.cameras.end()) return found->second;
  if (contents.cameras.size() == 1) return contents.cameras.begin()->second;
  throw InputError(name + ": has no topic " + beside + "; --intrinsics FX,FY,CX,CY is needed");
}

struct BagFrame {
  StampedPlace colour, depth;
  Transform<Map, Camera> T_map_camera;
};

class BagRecording : public Recording {
 public:
  BagRecording(const fs::path& file, const RecordingOptions& options) : bag_(file), name_(file.string()) {
    const Contents contents = contents_of(bag_, name_);
    const auto& [colour_topic, colour] = topic_of(contents, false, options.colour_topic, name_);
    const auto& [depth_topic, depth] = topic_of(contents, true, options.depth_topic, name_);
    camera_ = camera_of(contents, depth_topic, options, name_);
    scale_ = options.depth_scale.value_or(kMillimetres);
    if (!contents.frames.hangs_below(depth.frame, options.map_frame)) {
      throw InputError(name_ + ": /tf does not say where the frame '" + depth.frame + "' is in '" + options.map_frame +
                       "'");
    }
    add_frames(contents, colour, depth, options.map_frame);
    if (options.intrinsics && !frames_.empty()) {
      const DepthImage first = load_depth_image(frames_.front());
      camera_.width = first.width;
      camera_.height = first.height;
    }
    dropped_ = colour.images.size() - frames_.size();
    if (frames_.empty()) throw InputError(name_ + ": has no frame with colour, depth and a pose");
  }

  [[nodiscard]] std::string format() const override { return "ROS 1 bag"; }
  [[nodiscard]] std::size_t size() const override { return frames_.size(); }
  [[nodiscard]] std::size_t dropped() const override { return dropped_; }
  [[nodiscard]] PosedFrame load(std::size_t i) const override {
    const BagFrame& f = frames_.at(i);
    return {frame_of(parse_ros_colour(bag_.read(f.colour.place), name_), load_depth_image(f), camera_, f.depth.stamp,
                     name_),
            f.T_map_camera};
  }

 private:
  [[nodiscard]] DepthImage load_depth_image(const BagFrame& f) const {
    return parse_ros_depth(bag_.read(f.depth.place), scale_, name_);
  }
  void add_frames(const Contents& contents, const ImageTopic& colour, const ImageTopic& depth, const std::string& map) {
    const auto stamps_of = [](const ImageTopic& topic) {
      std::vector<Stamp> stamps;
      for (const StampedPlace& image : topic.images) stamps.push_back(image.stamp);
      return stamps;
    };
    for (const auto& [c, d] : associated(stamps_of(colour), stamps_of(depth))) {
      const auto T_map_camera = contents.frames.at(map, depth.frame, depth.images[d].stamp);
      if (T_map_camera) frames_.push_back({colour.images[c], depth.images[d], {*T_map_camera}});
    }
  }

  BagFile bag_;
  std::string name_;
  CameraIntrinsics camera_;
  double scale_ = kMillimetres;
  std::vector<BagFrame> frames_;
  std::size_t dropped_ = 0;
};

}  // namespace

std::unique_ptr<Recording> open_bag(const fs::path& file, const RecordingOptions& options) {
  return std::make_unique<BagRecording>(file, options);
}

}  // namespace amiss::dataset
