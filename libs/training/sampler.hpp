// What a robot's camera makes of a world, with the class of each point: what a forest learns from and is measured on.
// in: world with the poses of its bodies, class table, views T_world_camera     out: the cloud of a 1 cm TSDF of these
// views (mapping/surface_map.hpp, as 'amiss reconstruct' makes it), seen through the noise of the depth sensor and put
// together with poses that are a little wrong; the true class of each point, by the votes of the pixels that it is
// made of; kUnlabelled where nobody voted or the class table does not know the body.
// The same stream gives the same cloud for any number of threads.
#pragma once

#include <span>
#include <vector>

#include "core/random.hpp"
#include "core/semantic_class.hpp"
#include "core/sensors.hpp"
#include "world/class_table.hpp"

namespace amiss::training {

struct SamplerParams {
  CameraIntrinsics camera{320, 240, 269.2, 269.0, 157.4, 116.3};  // the HSR's at half its resolution
  double voxel_m = 0.01;
  double max_range_m = 2.0;
  double position_sigma_m = 0.004;  // of each view's pose
  double yaw_sigma_rad = radians(0.2);
};

struct LabelledCloud {
  Cloud<Map> cloud;
  std::vector<SemanticClass> classes;
};

[[nodiscard]] LabelledCloud sampled_cloud(const world::World& world, const world::ClassTable& classes,
                                          std::span<const Transform<World, Camera>> views, const SamplerParams& params,
                                          RandomStream& random);

/// The views of a robot that stands at a place and turns its head to both sides, low and high.
[[nodiscard]] std::vector<Transform<World, Camera>> views_around(const Pose2<World, Base>& stand, double eye_height_m);

}  // namespace amiss::training
