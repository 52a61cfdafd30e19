#include "recording/rawlog_frames.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <mutex>
#include <opencv2/imgcodecs.hpp>

#include "core/files.hpp"
#include "core/result.hpp"
#include "dataset/trajectory_files.hpp"
#include "recording/rawlog_reader.hpp"

namespace amiss::recording {

namespace {

namespace fs = std::filesystem;

constexpr double kMostGapS = 0.5;     // between two messages of odometry
constexpr double kSameCamera = 1e-6;  // numbers of intrinsics and poses
constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

struct Picture {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;
};

Picture decoded(const RawlogPicture& packed, const std::string& name) {
  std::vector<uchar> bytes(packed.bytes.begin(), packed.bytes.end());
  cv::Mat image;
  try {
    image = packed.is_jpeg ? cv::imdecode(bytes, cv::IMREAD_COLOR)
                           : cv::Mat(packed.height, packed.width, CV_8UC3, bytes.data());
  } catch (const cv::Exception&) {
    image = cv::Mat();
  }
  if (image.empty()) throw InputError(name + ": a picture is no JPEG that can be read");
  Picture picture{image.cols, image.rows, {}};
  picture.pixels.reserve(image.total());
  for (int row = 0; row < image.rows; ++row) {
    const auto* bgr = image.ptr<cv::Vec3b>(row);
    for (int column = 0; column < image.cols; ++column) {
      picture.pixels.push_back({bgr[column][2], bgr[column][1], bgr[column][0]});
    }
  }
  return picture;
}

bool is_one_camera(const RawlogFrame& frame, const Picture& picture) {
  const CameraIntrinsics &a = frame.camera, &b = frame.colour_camera;
  const double apart =
      std::max({std::abs(a.fx - b.fx), std::abs(a.fy - b.fy), std::abs(a.cx - b.cx), std::abs(a.cy - b.cy),
                (frame.T_camera_colour.matrix() - Eigen::Matrix4d::Identity()).cwiseAbs().maxCoeff()});
  return picture.width == a.width && picture.height == a.height && apart < kSameCamera;
}

/// The colour of each pixel that has a depth; a depth whose colour was not seen is taken out.
void take_colours(const RawlogFrame& from, const Picture& picture, RgbdFrame& frame) {
  const CameraIntrinsics &c = frame.intrinsics, &k = from.colour_camera;
  const Eigen::Isometry3d T_colour_camera = from.T_camera_colour.inverse();
  frame.colour.assign(frame.depth_m.size(), Rgb{});
  std::size_t i = 0;
  for (int v = 0; v < c.height; ++v) {
    for (int u = 0; u < c.width; ++u, ++i) {
      const auto z = static_cast<double>(frame.depth_m[i]);
      const Eigen::Vector3d p = T_colour_camera * Eigen::Vector3d((u - c.cx) / c.fx * z, (v - c.cy) / c.fy * z, z);
      const double column = std::round(k.fx * p.x() / p.z() + k.cx), row = std::round(k.fy * p.y() / p.z() + k.cy);
      const bool seen = p.z() > 0.0 && column >= 0.0 && row >= 0.0 && column < picture.width && row < picture.height;
      if (!seen) {
        frame.depth_m[i] = kNothing;
        continue;
      }
      const auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width);
      frame.colour[i] = picture.pixels[pixel + static_cast<std::size_t>(column)];
    }
  }
}

RgbdFrame rgbd_of(const RawlogFrame& from, const dataset::RecordingOptions& options, const std::string& name) {
  RgbdFrame frame{from.stamp, options.intrinsics.value_or(from.camera), {}, {}};
  CameraIntrinsics& c = frame.intrinsics;
  c.width = from.camera.width;
  c.height = from.camera.height;
  if (!(c.fx >= 1.0 && c.fy >= 1.0 && std::isfinite(c.fx + c.fy + c.cx + c.cy))) {
    throw InputError(name + ": its camera has no focal lengths; --intrinsics FX,FY,CX,CY gives them");
  }
  const double unit_m = options.depth_scale ? 1.0 / *options.depth_scale : static_cast<double>(from.depth_unit_m);
  frame.depth_m.reserve(from.depth.size());
  for (std::size_t i = 0; i < from.depth.size(); ++i) {
    const auto u = static_cast<double>(i % static_cast<std::size_t>(c.width));
    const auto v = static_cast<double>(i / static_cast<std::size_t>(c.width));
    const double ray = from.along_rays ? std::hypot((u - c.cx) / c.fx, (v - c.cy) / c.fy, 1.0) : 1.0;
    frame.depth_m.push_back(from.depth[i] == 0 ? kNothing : static_cast<float>(unit_m * from.depth[i] / ray));
  }
  Picture picture = decoded(*from.colour, name);
  if (is_one_camera(from, picture)) {
    frame.colour = std::move(picture.pixels);
  } else {
    take_colours(from, picture, frame);
  }
  return frame;
}

/// Where the robot was, by its odometry; its messages in the order of their times.
class Odometries {
 public:
  void add(const RawlogOdometry& odometry) { all_.push_back(odometry); }
  void sort() {
    std::stable_sort(all_.begin(), all_.end(), [](const auto& a, const auto& b) { return a.stamp < b.stamp; });
  }
  [[nodiscard]] bool empty() const { return all_.empty(); }
  [[nodiscard]] std::optional<Eigen::Isometry3d> T_odom_base(Stamp stamp) const {
    const auto after = std::lower_bound(all_.begin(), all_.end(), stamp,
                                        [](const RawlogOdometry& odometry, Stamp t) { return odometry.stamp < t; });
    if (after == all_.end()) return std::nullopt;
    if (after->stamp == stamp) return after->T_odom_base.lift().T;
    if (after == all_.begin()) return std::nullopt;
    const auto before = after - 1;
    const double gap_s = seconds(after->stamp - before->stamp);
    if (gap_s > kMostGapS) return std::nullopt;
    return dataset::between(before->T_odom_base.lift().T, after->T_odom_base.lift().T,
                            seconds(stamp - before->stamp) / gap_s);
  }

 private:
  std::vector<RawlogOdometry> all_;
};

class RawlogFrames final : public dataset::Recording {
 public:
  RawlogFrames(fs::path file, dataset::RecordingOptions options)
      : file_(std::move(file)), options_(std::move(options)) {
    Odometries odometries;
    std::vector<Frame> frames;
    RawlogReader reader(file_);
    std::size_t number = 0;
    while (const auto object = reader.next()) {
      if (const auto* odometry = std::get_if<RawlogOdometry>(&*object)) odometries.add(*odometry);
      const auto* frame = std::get_if<RawlogFrame>(&*object);
      if (frame == nullptr) continue;
      if (frame->colour) frames.push_back({number, frame->stamp, {frame->T_base_camera.T}});
      ++number;
    }
    complete_ = reader.complete();
    odometries.sort();
    place(frames, odometries);
    dropped_ = number - frames_.size();
    if (number == 0) throw InputError(file_.string() + ": has no depth images (CObservation3DRangeScan)");
    if (!frames_.empty()) return;
    throw InputError(file_.string() + ": has no frame with colour, depth and a pose (" + std::to_string(dropped_) +
                     " lack one of them)" +
                     (odometries.empty() ? "; it has no odometry, --poses FILE says where the camera was" : ""));
  }

  [[nodiscard]] std::string format() const override {
    return complete_ ? "MRPT rawlog" : "MRPT rawlog that breaks off";
  }
  [[nodiscard]] std::size_t size() const override { return frames_.size(); }
  [[nodiscard]] std::size_t dropped() const override { return dropped_; }

  /// The file is read on from the frame before; from its beginning for one that comes earlier.
  [[nodiscard]] dataset::PosedFrame load(std::size_t i) const override {
    const Frame& wanted = frames_.at(i);
    const std::lock_guard lock(reading_);
    if (!reader_ || next_ > wanted.number) {
      reader_ = std::make_unique<RawlogReader>(file_);
      next_ = 0;
    }
    while (const auto object = reader_->next()) {
      const auto* frame = std::get_if<RawlogFrame>(&*object);
      if (frame == nullptr || next_++ != wanted.number) continue;
      return {rgbd_of(*frame, options_, file_.string()), wanted.T_map_camera};
    }
    throw InputError(file_.string() + ": has fewer frames than a moment ago");
  }

 private:
  struct Frame {
    std::size_t number;  // among all frames of the file
    Stamp stamp;
    Transform<Map, Camera> T_map_camera;
  };

  /// Keeps the frames that have a pose; they come with that of the camera on the robot.
  void place(const std::vector<Frame>& frames, const Odometries& odometries) {
    std::vector<dataset::StampedPose> poses;
    if (!options_.poses.empty()) {
      poses = dataset::parse_tum_trajectory(load_bytes(options_.poses), options_.poses.string());
    }
    for (Frame frame : frames) {
      if (!options_.poses.empty()) {
        const auto pose = dataset::pose_at(poses, frame.stamp);
        if (!pose) continue;
        frame.T_map_camera = *pose;
      } else {
        const auto T_odom_base = odometries.T_odom_base(frame.stamp);
        if (!T_odom_base) continue;
        frame.T_map_camera.T = *T_odom_base * frame.T_map_camera.T;
      }
      frames_.push_back(frame);
    }
  }

  fs::path file_;
  dataset::RecordingOptions options_;
  std::vector<Frame> frames_;
  std::size_t dropped_ = 0;
  bool complete_ = false;
  mutable std::mutex reading_;
  mutable std::unique_ptr<RawlogReader> reader_;
  mutable std::size_t next_ = 0;  // number of the frame that comes next
};

}  // namespace

bool is_rawlog(const fs::path& file) {
  std::string begin(3, '\0');
  std::ifstream(file, std::ios::binary).read(begin.data(), static_cast<std::streamsize>(begin.size()));
  const auto flagged = static_cast<unsigned char>(begin[0]);
  return begin.starts_with("\x1f\x8b") || (flagged > 0x80 && (begin[1] == 'C' || begin.substr(1) == "mr"));
}

std::unique_ptr<dataset::Recording> open_rawlog(const fs::path& file, const dataset::RecordingOptions& options) {
  return std::make_unique<RawlogFrames>(file, options);
}

}  // namespace amiss::recording
