#include "segment/segment.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "core/result.hpp"
#include "segment/scene.hpp"

namespace amiss::segment {
namespace {

using testing::Body;
using testing::box_at;
using testing::ellipsoid_at;
using testing::look;
using testing::View;

constexpr Rgb kRed{200, 40, 40}, kBlue{40, 60, 190}, kBrown{120, 80, 50}, kWhite{235, 235, 235};

/// The bounding box of all bodies of an object.
Eigen::AlignedBox3d bounds_of(const std::vector<Body>& bodies, int object) {
  Eigen::AlignedBox3d box;
  for (const Body& body : bodies) {
    if (body.object != object) continue;
    const double c = std::abs(std::cos(body.yaw_rad)), s = std::abs(std::sin(body.yaw_rad));
    const Eigen::Vector3d half(c * body.size_m.x() / 2 + s * body.size_m.y() / 2,
                               s * body.size_m.x() / 2 + c * body.size_m.y() / 2, body.size_m.z() / 2);
    box.extend(body.centre_map - half);
    box.extend(body.centre_map + half);
  }
  return box;
}

/// A region as differencing would give it: the cylinder of the 5 cm voxels in which the camera saw the object.
Cylinder region_of(const View& view, int object) {
  Eigen::AlignedBox3d box;
  const CameraIntrinsics& k = view.frame.intrinsics;
  for (std::size_t i = 0; i < view.objects.size(); ++i) {
    if (view.objects[i] != object) continue;
    const auto z = static_cast<double>(view.frame.depth_m[i]);
    const auto u = static_cast<double>(i % 640), v = static_cast<double>(i / 640);
    const Eigen::Vector3d p = view.T_map_camera.T * Eigen::Vector3d((u - k.cx) / k.fx * z, (v - k.cy) / k.fy * z, z);
    if (p.z() < 0.0) continue;
    const Eigen::Vector3d corner = (p / 0.05).array().floor() * 0.05;
    box.extend(corner);
    box.extend(corner + Eigen::Vector3d::Constant(0.05));
  }
  return {box.center().head<2>(), box.sizes().head<2>().norm() / 2.0, box.min().z(), box.max().z()};
}

/// Part of the segment's pixels that show the object, and part of the object's pixels in the segment.
struct Overlap {
  double precision = 0.0, recall = 0.0;
};
Overlap overlap_of(const Segment& segment, const View& view, int object) {
  const auto all = static_cast<double>(std::count(view.objects.begin(), view.objects.end(), object));
  const auto shared =
      static_cast<double>(std::count_if(segment.pixels.begin(), segment.pixels.end(),
                                        [&](std::uint32_t pixel) { return view.objects[pixel] == object; }));
  return {shared / static_cast<double>(segment.pixels.size()), shared / all};
}

struct Case {
  std::string name;
  std::vector<Body> bodies;
  double tilt_rad;
  double max_error_m;
  double min_recall;
};

std::vector<Case> cases() {
  std::vector<Case> out;
  const double tilt = -0.75;
  out.push_back({"box", {box_at(1.0, 0.1, {0.16, 0.06, 0.21}, 0.4, kRed)}, tilt, 0.03, 0.9});
  out.push_back({"ball", {ellipsoid_at(0.95, 0.0, {0.22, 0.22, 0.22}, 0.0, kBlue)}, tilt, 0.05, 0.85});
  out.push_back({"shoe",
                 {ellipsoid_at(0.85, -0.05, {0.20, 0.10, 0.06}, 1.0, kWhite),
                  box_at(0.80, -0.13, {0.12, 0.09, 0.10}, 1.0, kBlue)},
                 tilt,
                 0.05,
                 0.8});
  out.push_back({"marker", {box_at(0.6, 0.05, {0.14, 0.02, 0.02}, 0.7, kBlue)}, -0.95, 0.03, 0.5});
  out.push_back({"thin marker", {box_at(0.9, 0.05, {0.12, 0.018, 0.018}, 1.4, kRed)}, tilt, 0.03, 0.3});
  out.push_back({"teddy",
                 {ellipsoid_at(0.8, 0.0, {0.20, 0.20, 0.22}, 0.0, kBrown),
                  ellipsoid_at(0.78, 0.0, {0.15, 0.15, 0.14}, 0.0, kBrown, 1, 0.18),
                  ellipsoid_at(0.68, 0.10, {0.16, 0.07, 0.07}, 0.3, kBrown),
                  ellipsoid_at(0.68, -0.10, {0.16, 0.07, 0.07}, -0.3, kWhite)},
                 tilt,
                 0.05,
                 0.9});
  out.push_back({"far box", {box_at(1.9, 0.3, {0.2, 0.2, 0.15}, 0.2, kRed)}, -0.45, 0.04, 0.8});
  return out;
}

TEST(SegmentRegion, FindsWholeObjectsAndTheirMiddle) {
  for (const Case& c : cases()) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(c.name + " seed " + std::to_string(seed));
      const View view = look(c.bodies, c.tilt_rad, seed);
      const Segmentation found = segment_region(view.frame, view.T_map_camera, region_of(view, 1), {});
      ASSERT_TRUE(found.ground.has_value());
      EXPECT_NEAR(found.ground->d_m, -testing::kFloorZ, 0.004);
      ASSERT_EQ(found.segments.size(), 1U);
      const Segment& segment = found.segments.front();
      const Overlap overlap = overlap_of(segment, view, 1);
      EXPECT_GT(overlap.precision, 0.97);
      EXPECT_GT(overlap.recall, c.min_recall);
      const Eigen::AlignedBox3d truth = bounds_of(c.bodies, 1);
      EXPECT_LT((segment.centre_map - truth.center()).norm(), c.max_error_m)
          << segment.centre_map.transpose() << " vs " << truth.center().transpose();
      EXPECT_NEAR(segment.size_m.z(), truth.sizes().z(), 0.015);
      EXPECT_FALSE(segment.cut);
    }
  }
}

TEST(SegmentRegion, KeepsTwoThingsApartThatDoNotTouch) {
  const std::vector<Body> bodies{box_at(0.95, 0.12, {0.1, 0.08, 0.12}, 0.2, kRed, 1),
                                 box_at(0.95, -0.05, {0.1, 0.08, 0.06}, -0.4, kRed, 2)};
  const View view = look(bodies, -0.75, 4);
  const Segmentation found = segment_region(view.frame, view.T_map_camera, {{0.95, 0.03}, 0.2, 0.0, 0.15}, {});
  ASSERT_EQ(found.segments.size(), 2U);
  EXPECT_GT(overlap_of(found.segments[0], view, 1).precision, 0.98);
  EXPECT_GT(overlap_of(found.segments[1], view, 2).precision, 0.98);
}

TEST(SegmentRegion, DropsTheWallAndTheTableLegAtTheBorderOfTheCrop) {
  const std::vector<Body> bodies{box_at(0.9, 0.0, {0.12, 0.1, 0.1}, 0.3, kRed, 1),
                                 box_at(1.2, 0.0, {0.1, 3.0, 2.5}, 0.0, kWhite, 2),
                                 box_at(0.9, 0.2, {0.05, 0.05, 0.7}, 0.0, kBrown, 3)};
  const View view = look(bodies, -0.75, 5);
  const Segmentation found = segment_region(view.frame, view.T_map_camera, {{0.9, 0.0}, 0.1, 0.0, 0.1}, {});
  ASSERT_EQ(found.segments.size(), 1U);
  EXPECT_GT(overlap_of(found.segments[0], view, 1).precision, 0.98);
  EXPECT_GE(found.dropped, 2);
}

TEST(SegmentRegion, FindsNothingOnAnEmptyFloorOrOutsideOfTheImage) {
  const View view = look({}, -0.75, 6);
  EXPECT_TRUE(segment_region(view.frame, view.T_map_camera, {{0.9, 0.0}, 0.2, 0.0, 0.1}, {}).segments.empty());
  const Segmentation behind = segment_region(view.frame, view.T_map_camera, {{-2.0, 0.0}, 0.2, 0.0, 0.1}, {});
  EXPECT_TRUE(behind.segments.empty());
  EXPECT_FALSE(behind.ground.has_value());
}

TEST(SegmentRegion, SurvivesAFrameWithoutDepth) {
  View view = look({}, -0.75, 6);
  view.frame.depth_m.assign(view.frame.depth_m.size(), std::numeric_limits<float>::quiet_NaN());
  EXPECT_TRUE(segment_region(view.frame, view.T_map_camera, {{0.9, 0.0}, 0.2, 0.0, 0.1}, {}).segments.empty());
  EXPECT_TRUE(segment_frame(view.frame, view.T_map_camera, {}).segments.empty());
  view.frame.colour.pop_back();
  EXPECT_THROW((void)segment_frame(view.frame, view.T_map_camera, {}), ArgumentError);
}

TEST(SegmentRegion, SameFrameSameSegments) {
  const Case c = cases().front();
  const View view = look(c.bodies, c.tilt_rad, 1);
  const Segmentation a = segment_region(view.frame, view.T_map_camera, region_of(view, 1), {});
  const Segmentation b = segment_region(view.frame, view.T_map_camera, region_of(view, 1), {});
  ASSERT_EQ(a.segments.size(), b.segments.size());
  EXPECT_EQ(a.segments[0].pixels, b.segments[0].pixels);
  EXPECT_EQ(a.segments[0].centre_map, b.segments[0].centre_map);
}

TEST(SegmentFrame, FindsTheThingsOnTheFloorAndNotTheFurniture) {
  const std::vector<Body> bodies{
      box_at(1.0, 0.2, {0.16, 0.06, 0.21}, 0.4, kRed, 1), ellipsoid_at(1.3, -0.3, {0.15, 0.15, 0.15}, 0.0, kBlue, 2),
      box_at(2.6, 0.0, {0.1, 5.0, 2.5}, 0.0, kWhite, 3), box_at(1.8, 0.9, {0.8, 0.7, 0.8}, 0.0, kBrown, 4)};
  const View view = look(bodies, -0.55, 7);
  const Segmentation found = segment_frame(view.frame, view.T_map_camera, {});
  std::map<int, int> hits;
  for (const Segment& segment : found.segments) {
    for (int object = 1; object <= 4; ++object) {
      if (overlap_of(segment, view, object).precision > 0.9) ++hits[object];
    }
  }
  EXPECT_EQ(hits[1], 1);
  EXPECT_EQ(hits[2], 1);
  EXPECT_EQ(hits[3] + hits[4], 0);
  EXPECT_EQ(found.segments.size(), 2U);
}

RC_GTEST_PROP(SegmentRegion, AnyBoxOnTheFloorIsOneSegmentWithItsMiddle, ()) {
  const auto between = [](int low, int high) { return *rc::gen::inRange(low, high + 1); };
  const Eigen::Vector3d size(between(40, 300) / 1000.0, between(40, 250) / 1000.0, between(30, 300) / 1000.0);
  const Body body = box_at(between(850, 1100) / 1000.0, between(-150, 150) / 1000.0, size, between(0, 31) / 10.0, kRed);
  const View view = look({body}, -0.75, static_cast<std::uint64_t>(between(1, 1000)));
  const Segmentation found = segment_region(view.frame, view.T_map_camera, region_of(view, 1), {});
  RC_ASSERT(found.segments.size() == 1U);
  RC_ASSERT((found.segments[0].centre_map - body.centre_map).norm() < 0.04);
  std::size_t last = 0;
  for (const std::uint32_t pixel : found.segments[0].pixels) {
    RC_ASSERT(pixel >= last);
    last = pixel;
  }
  RC_ASSERT(found.segments[0].cloud.points.size() == found.segments[0].pixels.size());
}

}  // namespace
}  // namespace amiss::segment
