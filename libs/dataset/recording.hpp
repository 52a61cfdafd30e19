// Recordings of an RGB-D camera with its poses, as users and others have them.
//
// in: a folder or file     out: frames one after the other: RgbdFrame (depth in metres, NaN where nothing came back)
// and T_map_camera, in the order of time. "map" is the frame of the recording's poses.
//
// Layouts of folders, told apart by their files:
//   TUM RGB-D   rgb.txt, depth.txt, groundtruth.txt (or associations.txt instead of the first two); colour and depth
//               belong together within 0.02 s, the pose is interpolated between two that are at most 0.5 s apart;
//               where there is an estimated.txt beside groundtruth.txt, the poses are taken from it
//   7-Scenes    frame-N.color.{png,jpg}, frame-N.depth.png, frame-N.pose.txt (4 x 4)
//   Open3D      color/ or image/ and depth/ with N.{png,jpg}, trajectory.log (the k-th entry is of the k-th depth)
// None of these says what the camera is. `camera.yaml` in the folder does (see camera_file.hpp), options overrule it.
// A file is a ROS 1 bag (2.0; plain, bz2 or lz4): sensor_msgs/Image of colour and registered depth, CameraInfo beside the
// depth, poses from /tf and /tf_static at the depth image's time.
// Errors: InputError naming file and line; nothing is loaded that does not fit (sizes, poses that are no rigid motion).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/sensors.hpp"

namespace amiss::dataset {

struct PosedFrame {
  RgbdFrame frame;
  Transform<Map, Camera> T_map_camera;
};

struct RecordingOptions {
  std::optional<CameraIntrinsics> intrinsics;  // width and height are taken from the images
  std::optional<double> depth_scale;           // units of the depth images for a metre: 1000 for mm, TUM's is 5000
  std::string colour_topic = {}, depth_topic = {};  // of a bag; empty: the HSR's, else the only one of its kind
  std::string map_frame = "map";               // of a bag: in which the poses are
  std::filesystem::path poses = {};            // of a TUM folder: a trajectory instead of its own
};

class Recording {
 public:
  virtual ~Recording() = default;
  Recording() = default;
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  [[nodiscard]] virtual std::string format() const = 0;   // for reports: "TUM RGB-D folder", ...
  [[nodiscard]] virtual std::size_t size() const = 0;     // frames that have colour, depth and a pose
  [[nodiscard]] virtual std::size_t dropped() const = 0;  // frames that lack one of the three
  [[nodiscard]] virtual PosedFrame load(std::size_t i) const = 0;
};

[[nodiscard]] std::unique_ptr<Recording> open_recording(const std::filesystem::path& path,
                                                        const RecordingOptions& options = {});

}  // namespace amiss::dataset
