#include "dataset/internal/bag_recording.hpp"

#include "core/result.hpp"
#include "dataset/camera_file.hpp"
#include "dataset/internal/bag_topics.hpp"
#include "dataset/internal/folder_index.hpp"

namespace amiss::dataset {
namespace {

namespace fs = std::filesystem;

constexpr double kMillimetres = 1000.0;

/// The topic that is named, else the HSR's, else the only one of its kind.
const std::pair<const std::string, PlacedTopic>& topic_of(const std::map<std::string, PlacedTopic>& topics, bool depth,
                                                          const std::string& wanted, const std::string& name) {
  const char* usual =
      depth ? "/hsrb/head_rgbd_sensor/depth_registered/image_rect_raw" : "/hsrb/head_rgbd_sensor/rgb/image_rect_color";
  const char* what = depth ? "depth (16UC1, mono16, 32FC1)" : "colour";
  const auto found = topics.find(wanted.empty() ? usual : wanted);
  if (found != topics.end()) return *found;
  if (wanted.empty() && topics.size() == 1) return *topics.begin();
  if (topics.empty()) throw InputError(name + ": has no images of " + what);
  std::string there;
  for (const auto& [topic, of_it] : topics) there += (there.empty() ? "" : ", ") + topic;
  throw InputError(name + ": " + (wanted.empty() ? "has several topics" : "has no topic '" + wanted + "'") + " of " +
                   what + "; there are: " + there);
}

CameraIntrinsics camera_of(const BagTopics& topics, const std::string& depth_topic, const RecordingOptions& options,
                           const std::string& name) {
  if (options.intrinsics) return *options.intrinsics;
  if (const auto camera = camera_beside(topics, depth_topic, name)) return *camera;
  throw InputError(name + ": has no topic " + depth_topic.substr(0, depth_topic.rfind('/')) +
                   "/camera_info; --intrinsics FX,FY,CX,CY is needed");
}

struct BagFrame {
  StampedPlace colour, depth;
  Transform<Map, Camera> T_map_camera;
};

class BagRecording : public Recording {
 public:
  BagRecording(const fs::path& file, const RecordingOptions& options) : bag_(file), name_(file.string()) {
    const BagTopics contents = topics_of(bag_, name_);
    const auto& [colour_topic, colour] = topic_of(contents.colours, false, options.colour_topic, name_);
    const auto& [depth_topic, depth] = topic_of(contents.depths, true, options.depth_topic, name_);
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
    dropped_ = colour.places.size() - frames_.size();
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
  void add_frames(const BagTopics& contents, const PlacedTopic& colour, const PlacedTopic& depth,
                  const std::string& map) {
    const auto stamps_of = [](const PlacedTopic& topic) {
      std::vector<Stamp> stamps;
      for (const StampedPlace& image : topic.places) stamps.push_back(image.stamp);
      return stamps;
    };
    for (const auto& [c, d] : associated(stamps_of(colour), stamps_of(depth))) {
      const auto T_map_camera = contents.frames.at(map, depth.frame, depth.places[d].stamp);
      if (T_map_camera) frames_.push_back({colour.places[c], depth.places[d], {*T_map_camera}});
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
