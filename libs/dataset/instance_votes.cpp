#include "dataset/instance_votes.hpp"

#include <algorithm>
#include <cmath>

#include "core/result.hpp"

namespace amiss::dataset {
namespace {

constexpr float kNearest_m = 0.2F;
constexpr float kSurfaceWithin_m = 0.015F;     // between a point and the depth image, at any range
constexpr float kSurfaceWithin_per_m = 0.004F;  // and this for each square metre of the range

float tolerance_m(float z_m) { return kSurfaceWithin_m + kSurfaceWithin_per_m * z_m * z_m; }

}  // namespace

InstanceVotes::InstanceVotes(std::vector<Eigen::Vector3f> points_map)
    : points_map_(std::move(points_map)), votes_(points_map_.size()) {}

void InstanceVotes::count(Votes& votes, std::uint16_t number) {
  std::size_t least = 0;
  for (std::size_t k = 0; k < kKinds; ++k) {
    if (votes.count[k] > 0 && votes.number[k] == number) {
      ++votes.count[k];
      return;
    }
    if (votes.count[k] < votes.count[least]) least = k;
  }
  if (votes.count[least] == 0) votes.number[least] = number;
  votes.count[least] = static_cast<std::uint16_t>(votes.count[least] == 0 ? 1 : votes.count[least] - 1);
}

void InstanceVotes::add(const PosedFrame& posed, std::span<const std::uint16_t> numbers) {
  const CameraIntrinsics& camera = posed.frame.intrinsics;
  if (numbers.size() != posed.frame.depth_m.size()) throw ArgumentError("instances and depth differ in size");
  const Eigen::Isometry3f T_camera_map = posed.T_map_camera.T.inverse().cast<float>();
  const auto fx = static_cast<float>(camera.fx), fy = static_cast<float>(camera.fy);
  const auto cx = static_cast<float>(camera.cx), cy = static_cast<float>(camera.cy);
  for (std::size_t i = 0; i < points_map_.size(); ++i) {
    const Eigen::Vector3f p = T_camera_map * points_map_[i];
    if (!(p.z() > kNearest_m)) continue;
    const float u = fx * p.x() / p.z() + cx + 0.5F, v = fy * p.y() / p.z() + cy + 0.5F;
    if (!(u >= 0.0F && v >= 0.0F && u < static_cast<float>(camera.width) && v < static_cast<float>(camera.height))) {
      continue;
    }
    const std::size_t pixel =
        static_cast<std::size_t>(v) * static_cast<std::size_t>(camera.width) + static_cast<std::size_t>(u);
    const bool saw = std::abs(posed.frame.depth_m[pixel] - p.z()) < tolerance_m(p.z());  // false for NaN
    if (saw && numbers[pixel] != 0) count(votes_[i], numbers[pixel]);
  }
}

std::vector<std::uint16_t> InstanceVotes::numbers() const {
  std::vector<std::uint16_t> result(votes_.size(), 0);
  for (std::size_t i = 0; i < votes_.size(); ++i) {
    std::uint16_t most = 0;
    for (std::size_t k = 0; k < kKinds; ++k) {
      const std::uint16_t count = votes_[i].count[k], number = votes_[i].number[k];
      if (count == 0 || count < most || (count == most && number > result[i])) continue;
      most = count;
      result[i] = number;
    }
  }
  return result;
}

}  // namespace amiss::dataset
