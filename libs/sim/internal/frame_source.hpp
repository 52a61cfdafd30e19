// The camera between the instant of a frame and its arrival: frames are rendered by the worker from copies of all
// poses, in order, and joined when they are due; the caller's thread adds the noise then.
#pragma once

#include <deque>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "core/worker.hpp"
#include "robot/robot.hpp"
#include "sim/depth_noise.hpp"
#include "sim/renderer.hpp"
#include "world/truth.hpp"

namespace amiss::sim::internal {

/// Where everything is at one instant.
struct Scene {
  Transform<amiss::World, Camera> T_world_camera;
  std::vector<Transform<amiss::World, Object>> poses;
  std::vector<std::size_t> hidden;
};

class FrameSource {
 public:
  FrameSource(const world::World& world, const CameraIntrinsics& intrinsics, const DepthNoiseParams& params,
              std::uint64_t seed, Worker& worker);
  ~FrameSource();
  FrameSource(const FrameSource&) = delete;
  FrameSource& operator=(const FrameSource&) = delete;

  void capture(Stamp now, Duration delay, Scene scene, const Transform<Base, Camera>& T_base_camera,
               const Pose2<Odom, Base>& T_odom_base);
  [[nodiscard]] std::optional<robot::CapturedFrame> arrival(Stamp now);
  [[nodiscard]] const world::InstanceImage* instances_of(Stamp stamp) const;
  [[nodiscard]] RenderedFrame picture(const Scene& scene, const CameraIntrinsics& intrinsics);
  void add_body(const world::Body& body);
  [[nodiscard]] double render_cpu_s() const { return render_cpu_s_; }
  [[nodiscard]] double noise_cpu_s() const { return noise_cpu_s_; }

 private:
  struct Shot {
    RenderedFrame frame;
    double render_cpu_s = 0.0;
  };
  struct Pending {
    Stamp stamp, arrives;
    Transform<Base, Camera> T_base_camera;
    Pose2<Odom, Base> T_odom_base;
    std::future<Shot> shot;
  };
  [[nodiscard]] Shot shoot(const Scene& scene);
  void wait_for_all() const;

  CameraIntrinsics intrinsics_;
  Renderer renderer_;
  DepthNoise noise_;
  RandomStream random_;
  Worker& worker_;
  std::deque<Pending> pending_;
  std::deque<world::InstanceImage> delivered_;
  double render_cpu_s_ = 0.0, noise_cpu_s_ = 0.0;
};

}  // namespace amiss::sim::internal
