#include "semantics/onnx_labeller.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "semantics/small_network.hpp"

namespace amiss::semantics {
namespace {

using C = SemanticClass;

OnnxLabeller labeller() {
  return OnnxLabeller(ImageNetwork(test::colour_network(32, 24), {32, 24}, {C::kWall, C::kFloor, C::kTable}, "c.onnx"),
                      {.voxel_m = 0.05, .max_range_m = 3.0, .stride_px = 1});
}

/// A wall 1 m before the camera in one colour.
RgbdFrame wall(const Rgb& colour) {
  RgbdFrame frame;
  frame.intrinsics = {60, 40, 60, 60, 29.5, 19.5};
  frame.colour.assign(60 * 40, colour);
  frame.depth_m.assign(60 * 40, 1.0F);
  return frame;
}

TEST(OnnxLabeller, FusesFramesByVotes) {
  OnnxLabeller onnx = labeller();
  const Transform<Map, Camera> pose;  // the map's z is where the camera looks
  onnx.look(wall({200, 0, 0}), pose);
  onnx.look(wall({0, 200, 0}), pose);
  onnx.look(wall({0, 220, 0}), pose);
  const Cloud<Map> cloud{{{0, 0, 1.0F}, {0.2F, 0.1F, 1.0F}, {0, 0, 2.0F}}, {}, {}};
  EXPECT_EQ(onnx.label(cloud), (std::vector<C>{C::kFloor, C::kFloor, C::kUnlabelled}));
}

TEST(OnnxLabeller, SaysWhichNetworkItIs) { EXPECT_EQ(labeller().identity().to_line(), "onnx (c.onnx, learned)"); }

TEST(OnnxLabeller, AsksForCloudsThatFit) {
  const Cloud<Map> odd{{{0, 0, 1}}, {{}, {}}, {}};
  EXPECT_THROW((void)labeller().label(odd), ArgumentError);
}

}  // namespace
}  // namespace amiss::semantics
