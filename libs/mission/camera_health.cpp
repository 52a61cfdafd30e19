#include "mission/camera_health.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace amiss::mission {

namespace {

constexpr double kMovedM = 0.03, kMovedRad = 0.04;  // of a camera that should see something else
constexpr int kStride = 8;                          // of the pixels that are looked at
constexpr double kDeepM = 3.0;                      // floor that is farther away says little
constexpr double kSameDepth = 0.1;                  // part of the depth between neighbours of one surface
constexpr double kLeastCoherent = 0.5;
constexpr int kLeastPixels = 200;
constexpr double kTooLong = 1.1;      // measured over expected: behind the floor
constexpr double kMostTooLong = 0.3;  // part of the rays
constexpr double kShort = 0.93, kAlike = 0.03, kMostlyAlike = 0.7;
constexpr int kBadFrames = 4;                            // in a row
constexpr double kShortWayM = 1.0, kShortTurnRad = 1.5;  // a table or bed does not fill the view for so long

bool is_same(const RgbdFrame& a, const RgbdFrame& b) {
  return a.depth_m.size() == b.depth_m.size() &&
         std::memcmp(a.depth_m.data(), b.depth_m.data(), a.depth_m.size() * sizeof(float)) == 0;
}

bool has_moved(const robot::CapturedFrame& a, const robot::CapturedFrame& b) {
  const Pose2<Base, Base> moved = a.T_odom_base.inverse() * b.T_odom_base;
  const Eigen::AngleAxisd turned(a.T_base_camera.T.linear().transpose() * b.T_base_camera.T.linear());
  return moved.position().norm() > kMovedM || std::abs(moved.yaw_rad) + std::abs(turned.angle()) > kMovedRad;
}

}  // namespace

double coherent_part(const RgbdFrame& frame) {
  int compared = 0, alike = 0;
  const auto width = static_cast<std::size_t>(frame.intrinsics.width);
  for (std::size_t v = 0; v < static_cast<std::size_t>(frame.intrinsics.height); v += kStride) {
    for (std::size_t u = 0; u + 1 < width; u += kStride) {
      const float a = frame.depth_m[v * width + u], b = frame.depth_m[v * width + u + 1];
      if (!std::isfinite(a) || !std::isfinite(b)) continue;
      ++compared;
      if (std::abs(a - b) < static_cast<float>(kSameDepth) * a) ++alike;
    }
  }
  return compared < kLeastPixels ? 1.0 : static_cast<double>(alike) / compared;
}

FloorScale floor_scale(const RgbdFrame& frame, const Transform<Base, Camera>& T_base_camera) {
  const CameraIntrinsics& k = frame.intrinsics;
  const Eigen::Vector3d down = T_base_camera.T.linear().row(2);
  const double height_m = T_base_camera.T.translation().z();
  std::vector<double> ratios;
  for (int v = 0; v < k.height; v += kStride) {
    for (int u = 0; u < k.width; u += kStride) {
      const double fall = down.dot(Eigen::Vector3d((u - k.cx) / k.fx, (v - k.cy) / k.fy, 1.0));
      const double expected_m = fall < -1e-6 ? -height_m / fall : kDeepM;
      const auto pixel = static_cast<std::size_t>(v) * static_cast<std::size_t>(k.width) + static_cast<std::size_t>(u);
      const auto depth_m = static_cast<double>(frame.depth_m[pixel]);
      if (expected_m < kDeepM && std::isfinite(depth_m)) ratios.push_back(depth_m / expected_m);
    }
  }
  if (ratios.size() < static_cast<std::size_t>(kLeastPixels)) return {};
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  const double median = *middle;
  const auto part = [&](const auto& which) {
    return static_cast<double>(std::count_if(ratios.begin(), ratios.end(), which)) / static_cast<double>(ratios.size());
  };
  return {part([](double r) { return r > kTooLong; }), median,
          part([&](double r) { return std::abs(r - median) < kAlike * median; })};
}

bool CameraHealth::repeats(const robot::CapturedFrame& captured) {
  if (!last_ || !is_same(last_->frame, captured.frame)) {
    stuck_since_.reset();
    return false;
  }
  if (!has_moved(*last_, captured)) return false;  // it stands and sees the same
  if (!stuck_since_) stuck_since_ = last_->frame.stamp;
  return true;
}

void CameraHealth::watch_scale(const robot::CapturedFrame& captured, bool is_short) {
  if (!is_short || !short_since_) short_way_m_ = short_turn_rad_ = 0.0;
  if (!is_short) short_since_.reset();
  if (is_short && !short_since_) short_since_ = captured.frame.stamp;
  if (!is_short || !last_) return;
  const Pose2<Base, Base> moved = last_->T_odom_base.inverse() * captured.T_odom_base;
  short_way_m_ += moved.position().norm();
  short_turn_rad_ += std::abs(moved.yaw_rad);
}

bool CameraHealth::accept(const robot::CapturedFrame& captured) {
  if (repeats(captured)) return false;
  const FloorScale scale = floor_scale(captured.frame, captured.T_base_camera);
  watch_scale(captured, scale.median < kShort && scale.alike > kMostlyAlike);
  last_ = {{captured.frame.stamp, captured.frame.intrinsics, {}, captured.frame.depth_m},
           captured.T_base_camera,
           captured.T_odom_base};
  const bool is_garbage = coherent_part(captured.frame) < kLeastCoherent;
  if (is_garbage || scale.too_long > kMostTooLong) {
    bad_ = is_garbage ? Complaint::kGarbage : Complaint::kWrong;
    if (++bad_frames_ == 1) bad_since_ = captured.frame.stamp;
    return false;
  }
  bad_frames_ = 0;
  heard_ = captured.frame.stamp;
  return true;
}

std::optional<Trouble> CameraHealth::trouble(Stamp now) const {
  if (stuck_since_) return Trouble{Sense::kCamera, Complaint::kStuck, *stuck_since_};
  if (bad_frames_ >= kBadFrames) return Trouble{Sense::kCamera, bad_, *bad_since_};
  if (short_way_m_ > kShortWayM && short_turn_rad_ > kShortTurnRad) {
    return Trouble{Sense::kCamera, Complaint::kWrong, *short_since_};
  }
  if (now - heard_ > duration_of(params_.silent_s)) return Trouble{Sense::kCamera, Complaint::kSilent, heard_};
  return std::nullopt;
}

}  // namespace amiss::mission
