#include "dataset/tum_writer.hpp"

#include "core/files.hpp"
#include "core/result.hpp"
#include "dataset/internal/images.hpp"
#include "dataset/internal/text.hpp"

namespace amiss::dataset {

TumWriter::TumWriter(std::filesystem::path folder, const CameraFile& camera)
    : folder_(std::move(folder)), camera_(camera) {
  std::filesystem::create_directories(folder_ / "rgb");
  std::filesystem::create_directories(folder_ / "depth");
  for (const char* part : {"rgb", "depth"}) {
    if (!std::filesystem::is_empty(folder_ / part)) {
      throw ArgumentError((folder_ / part).string() + ": must be empty for a new recording");
    }
  }
}

void TumWriter::add(const PosedFrame& posed, const std::optional<Transform<Map, Camera>>& T_map_camera_true) {
  const RgbdFrame& frame = posed.frame;
  if (frame.intrinsics != camera_.intrinsics) throw ArgumentError("all frames of a recording must be of one camera");
  if (!poses_.empty() && frame.stamp <= poses_.back().stamp) throw ArgumentError("the times of frames must grow");
  if (!poses_.empty() && T_map_camera_true.has_value() == true_poses_.empty()) {
    throw ArgumentError("all frames of a recording must have a true pose beside the estimated one, or none");
  }
  const int width = frame.intrinsics.width, height = frame.intrinsics.height;
  const std::string time = text_of(frame.stamp);
  const std::string colour = time + " rgb/" + time + ".png", depth = time + " depth/" + time + ".png";
  save_atomically(folder_ / "rgb" / (time + ".png"), png_bytes(frame.colour, width, height));
  save_atomically(folder_ / "depth" / (time + ".png"),
                  depth_png_bytes(frame.depth_m, width, height, camera_.depth_scale));
  colour_list_.append(colour).append("\n");
  depth_list_.append(depth).append("\n");
  pairs_.append(colour).append(" ").append(depth).append("\n");
  poses_.push_back({frame.stamp, posed.T_map_camera});
  if (T_map_camera_true) true_poses_.push_back({frame.stamp, *T_map_camera_true});
}

void TumWriter::finish() const {
  save_camera(folder_ / "camera.yaml", camera_);
  save_atomically(folder_ / "rgb.txt", "# timestamp filename\n" + colour_list_);
  save_atomically(folder_ / "depth.txt", "# timestamp filename\n" + depth_list_);
  if (!true_poses_.empty()) save_atomically(folder_ / "estimated.txt", tum_trajectory_bytes(poses_));
  save_atomically(folder_ / "groundtruth.txt", tum_trajectory_bytes(true_poses_.empty() ? poses_ : true_poses_));
}

void TumWriter::save_associations() const { save_atomically(folder_ / "associations.txt", pairs_); }

}  // namespace amiss::dataset
