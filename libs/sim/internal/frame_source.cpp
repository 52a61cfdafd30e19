#include "sim/internal/frame_source.hpp"

#include <algorithm>

#include "sim/internal/cpu_meter.hpp"

namespace amiss::sim::internal {
namespace {
constexpr std::size_t kKeptFrames = 20;
}

FrameSource::FrameSource(const world::World& world, const CameraIntrinsics& intrinsics, const DepthNoiseParams& params,
                         std::uint64_t seed, Worker& worker)
    : intrinsics_(intrinsics), renderer_(world), noise_(params, intrinsics), random_(seed, "camera"), worker_(worker) {}

FrameSource::~FrameSource() { wait_for_all(); }

FrameSource::Shot FrameSource::shoot(const Scene& scene) {
  Shot shot;
  const CpuMeter meter(shot.render_cpu_s);
  shot.frame = renderer_.render(scene.T_world_camera, intrinsics_, scene.poses, {.hidden = scene.hidden});
  return shot;
}

void FrameSource::capture(Stamp now, Duration delay, Scene scene, const Transform<Base, Camera>& T_base_camera,
                          const Pose2<Odom, Base>& T_odom_base) {
  auto job = [this, scene = std::move(scene)] { return shoot(scene); };
  pending_.push_back({now, now + delay, T_base_camera, T_odom_base, worker_.submit(std::move(job))});
}

std::optional<robot::CapturedFrame> FrameSource::arrival(Stamp now) {
  if (pending_.empty() || pending_.front().arrives > now) return std::nullopt;
  Pending first = std::move(pending_.front());
  pending_.pop_front();
  Shot shot = first.shot.get();
  render_cpu_s_ += shot.render_cpu_s;
  delivered_.push_back({first.stamp, intrinsics_.width, intrinsics_.height, std::move(shot.frame.instances)});
  if (delivered_.size() > kKeptFrames) delivered_.pop_front();
  // Noise is added here, so that two threads share the camera's work; frames arrive in the order of their stamps.
  const CpuMeter meter(noise_cpu_s_);
  return robot::CapturedFrame{noise_.apply(std::move(shot.frame), first.stamp, random_), first.T_base_camera,
                              first.T_odom_base};
}

const world::InstanceImage* FrameSource::instances_of(Stamp stamp) const {
  const auto found =
      std::find_if(delivered_.begin(), delivered_.end(), [&](const auto& i) { return i.stamp == stamp; });
  return found == delivered_.end() ? nullptr : &*found;
}

RenderedFrame FrameSource::picture(const Scene& scene, const CameraIntrinsics& intrinsics) {
  wait_for_all();
  return renderer_.render(scene.T_world_camera, intrinsics, scene.poses, {.hidden = scene.hidden});
}

void FrameSource::add_body(const world::Body& body) {
  wait_for_all();
  renderer_.add_body(body);
}

void FrameSource::wait_for_all() const {
  for (const Pending& frame : pending_) {
    if (frame.shot.valid()) frame.shot.wait();
  }
}

}  // namespace amiss::sim::internal
