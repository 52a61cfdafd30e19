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

void TumWriter::add(const PosedFrame& posed) {
  const RgbdFrame& frame = posed.frame;
  if (frame.intrinsics != camera_.intrinsics) throw ArgumentError("all frames of a recording must be of one camera");
  if (!poses_.empty() && frame.stamp <= poses_.back().stamp) throw ArgumentError("the times of frames must grow");
  const int width = frame.intrinsics.width, height = frame.intrinsics.height;
  const std::string time = text_of(frame.stamp), file = time + ".png";
  save_atomically(folder_ / "rgb" / file, png_bytes(frame.colour, width, height));
  save_atomically(folder_ / "depth" / file, depth_png_bytes(frame.depth_m, width, height, camera_.depth_scale));
  std::string line = time;
  line += " rgb/" + file + "\n";
  colour_list_ += line;
  line = time;
  line += " depth/" + file + "\n";
  depth_list_ += line;
  poses_.push_back({frame.stamp, posed.T_map_camera});
}

void TumWriter::finish() const {
  save_camera(folder_ / "camera.yaml", camera_);
  save_atomically(folder_ / "rgb.txt", "# timestamp filename\n" + colour_list_);
  save_atomically(folder_ / "depth.txt", "# timestamp filename\n" + depth_list_);
  save_atomically(folder_ / "groundtruth.txt", tum_trajectory_bytes(poses_));
}

}  // namespace amiss::dataset
