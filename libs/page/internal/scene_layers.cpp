#include "page/internal/scene_layers.hpp"

#include <mrpt/opengl/CBox.h>
#include <mrpt/opengl/CCylinder.h>
#include <mrpt/opengl/COctoMapVoxels.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt/opengl/CSphere.h>
#include <mrpt/opengl/CText.h>

#include <algorithm>
#include <iterator>

namespace amiss::page {

namespace gl = mrpt::opengl;

namespace {

using Colour = mrpt::img::TColor;
using Voxels = std::vector<mapping::Voxel>;

// Okabe and Ito's, as on the page.
const Colour kOrange(230, 159, 0), kSky(86, 180, 233), kGreen(0, 158, 115), kYellow(240, 228, 66), kBlue(0, 114, 178),
    kVermillion(213, 94, 0), kPurple(204, 121, 167), kGrey(138, 143, 152);
const Colour kFree(222, 225, 230), kWall(96, 102, 112), kReference(176, 181, 188), kNow(107, 142, 178),
    kGrid(150, 155, 163);
// Heights of what lies on the floor, one over the other.
constexpr double kFloor_m = -0.04, kGrid_m = 0.0, kView_m = 0.03, kWay_m = 0.06, kWanted_m = 0.08;

Colour with_alpha(Colour colour, std::uint8_t alpha) {
  colour.A = alpha;
  return colour;
}

mrpt::math::TPoint3Df point(double x, double y, double z) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

mrpt::poses::CPose3D pose_of(const Eigen::Isometry3d& T) {
  return mrpt::poses::CPose3D(mrpt::math::CMatrixDouble44(T.matrix()));
}

void insert(gl::CSetOfTriangles& set, const mrpt::math::TPoint3Df& a, const mrpt::math::TPoint3Df& b,
            const mrpt::math::TPoint3Df& c, const Colour& colour) {
  gl::TTriangle triangle(a, b, c);
  triangle.setColor(colour);
  set.insertTriangle(triangle);
}

Voxels without(const Voxels& some, const Voxels& others) {
  Voxels rest;
  std::set_difference(some.begin(), some.end(), others.begin(), others.end(), std::back_inserter(rest));
  return rest;
}

Voxels sorted(Voxels voxels) {
  std::sort(voxels.begin(), voxels.end());
  return voxels;
}

void strip(gl::CSetOfLines& lines, const std::vector<Eigen::Vector2d>& points, double z_m) {
  for (std::size_t i = 1; i < points.size(); ++i)
    lines.appendLine(points[i - 1].x(), points[i - 1].y(), z_m, points[i].x(), points[i].y(), z_m);
}

/// A way as a band on the floor, which is seen better than a line of one pixel.
void band(gl::CSetOfTriangles& set, const std::vector<Eigen::Vector2d>& points, double z_m, const Colour& colour) {
  constexpr double kWidth_m = 0.04, kShortest_m = 1e-4;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Eigen::Vector2d &from = points[i - 1], &to = points[i];
    if ((to - from).norm() < kShortest_m) continue;
    const Eigen::Vector2d aside = 0.5 * kWidth_m * Eigen::Vector2d(from.y() - to.y(), to.x() - from.x()).normalized();
    const auto corner = [&](const Eigen::Vector2d& p, double side) {
      return point(p.x() + side * aside.x(), p.y() + side * aside.y(), z_m);
    };
    insert(set, corner(from, -1.0), corner(to, -1.0), corner(to, 1.0), colour);
    insert(set, corner(from, -1.0), corner(to, 1.0), corner(from, 1.0), colour);
  }
}

/// MRPT's cylinders stand on their origin.
gl::CCylinder::Ptr cylinder(double radius_m, double height_m) {
  constexpr int kSlices = 32;
  return gl::CCylinder::Create(static_cast<float>(radius_m), static_cast<float>(radius_m), static_cast<float>(height_m),
                               kSlices);
}

gl::CBox::Ptr box(const Eigen::Vector3d& size_m) {
  const Eigen::Vector3d half = 0.5 * size_m;
  return gl::CBox::Create(mrpt::math::TPoint3D(-half.x(), -half.y(), -half.z()),
                          mrpt::math::TPoint3D(half.x(), half.y(), half.z()));
}

gl::CRenderizable::Ptr shown(const StoryRobot::Shape& shape) {
  gl::CRenderizable::Ptr thing;
  Eigen::Isometry3d T = shape.T_base_shape;
  switch (shape.kind) {
    case StoryRobot::Kind::kBox:
      thing = box(shape.size_m);
      break;
    case StoryRobot::Kind::kCylinder:
      thing = cylinder(shape.size_m.x(), shape.size_m.y());
      T.translate(Eigen::Vector3d(0.0, 0.0, -0.5 * shape.size_m.y()));
      break;
    case StoryRobot::Kind::kSphere:
      thing = gl::CSphere::Create(static_cast<float>(shape.size_m.x()));
      break;
  }
  thing->setPose(pose_of(T));
  thing->setColor(shape.rgb.x(), shape.rgb.y(), shape.rgb.z());
  return thing;
}

}  // namespace

/// A square for each cell and short pieces of line: over long ones MRPT's shaders lose the depth, and what lies below
/// shows through.
void SceneLayers::add_floor() const {
  const FloorGrid& floor = story_.floor;
  const auto plan = add<gl::CSetOfTriangles>("floor plan");
  const double half = 0.5 * floor.resolution_m();
  Eigen::AlignedBox2d known;
  for (int y = 0; y < floor.height(); ++y) {
    for (int x = 0; x < floor.width(); ++x) {
      const Occupancy value = floor.at(Cell{x, y});
      if (value == Occupancy::kUnknown) continue;
      const Eigen::Vector2d p = floor.centre_of({x, y});
      known.extend(p);
      const Colour& colour = value == Occupancy::kFree ? kFree : kWall;
      const auto a = point(p.x() - half, p.y() - half, kFloor_m), b = point(p.x() + half, p.y() - half, kFloor_m),
                 c = point(p.x() + half, p.y() + half, kFloor_m), d = point(p.x() - half, p.y() + half, kFloor_m);
      insert(*plan, a, b, c, colour);
      insert(*plan, a, c, d, colour);
    }
  }
  constexpr double kLargest_m = 300.0;
  if (!known.isEmpty() && known.sizes().maxCoeff() < kLargest_m) add_grid(known);
}

/// Lines along whole metres of the map.
void SceneLayers::add_grid(const Eigen::AlignedBox2d& floor) const {
  constexpr int kPieces = 4;  // of a metre
  const auto grid = add<gl::CSetOfLines>("grid");
  grid->setColor_u8(kGrid);
  const Eigen::Vector2i low = floor.min().array().floor().cast<int>(), high = floor.max().array().ceil().cast<int>();
  for (int y = low.y(); y <= high.y(); ++y) {
    for (int i = low.x() * kPieces; i < high.x() * kPieces; ++i)
      grid->appendLine(i / double{kPieces}, y, kGrid_m, (i + 1) / double{kPieces}, y, kGrid_m);
  }
  for (int x = low.x(); x <= high.x(); ++x) {
    for (int i = low.y() * kPieces; i < high.y() * kPieces; ++i)
      grid->appendLine(x, i / double{kPieces}, kGrid_m, x, (i + 1) / double{kPieces}, kGrid_m);
  }
}

void SceneLayers::add_voxels() const {
  const auto layer = [this](const std::string& name, const Voxels& voxels, const Colour& colour) {
    const auto set = add<gl::COctoMapVoxels>(name);
    set->setVisualizationMode(gl::COctoMapVoxels::FIXED);
    set->enableLights(true);
    set->enableCubeTransparency(false);
    set->resizeVoxelSets(1);
    set->reserveVoxels(0, voxels.size());
    mrpt::math::TPoint3D low(0, 0, 0), high(0, 0, 0);
    for (const mapping::Voxel& v : voxels) {
      const Eigen::Vector3d p = story_.resolution_m * (Eigen::Vector3d(v.x, v.y, v.z).array() + 0.5);
      set->push_back_Voxel(0, {point(p.x(), p.y(), p.z()), story_.resolution_m, colour});
      low = {std::min(low.x, p.x()), std::min(low.y, p.y()), std::min(low.z, p.z())};
      high = {std::max(high.x, p.x()), std::max(high.y, p.y()), std::max(high.z, p.z())};
    }
    set->setBoundingBox(low, high);
  };
  const StoryDifference* difference = latest(story_.differences, t_s_);
  const Voxels appeared = difference == nullptr ? Voxels() : sorted(difference->appeared);
  const Voxels vanished = difference == nullptr ? Voxels() : without(sorted(difference->vanished), appeared);
  const Voxels now = without(without(voxels_at(story_, t_s_), appeared), vanished);
  layer("reference map", without(without(without(sorted(story_.reference), now), appeared), vanished), kReference);
  layer("map now", now, kNow);
  layer("appeared", appeared, kOrange);
  layer("vanished", vanished, kBlue);
}

void SceneLayers::add_views() const {
  const auto* views = latest(story_.views, t_s_);
  if (views == nullptr) return;
  for (const StoryView& view : *views) {
    if (view.dropped) continue;
    const double side_m = view.height_m / std::cos(0.5 * view.angle_rad);
    const Eigen::Vector2d apex = view.T_map_base.position();
    const auto corner = [&](double turn_rad) -> Eigen::Vector2d {
      const double yaw = view.T_map_base.yaw_rad + turn_rad;
      return apex + side_m * Eigen::Vector2d(std::cos(yaw), std::sin(yaw));
    };
    const Eigen::Vector2d left = corner(0.5 * view.angle_rad), right = corner(-0.5 * view.angle_rad);
    const auto name = "view " + std::to_string(view.id);
    const auto edge = add<gl::CSetOfLines>(name);
    strip(*edge, {apex, right, left, apex}, kView_m);
    edge->setColor_u8(with_alpha(kSky, view.visited ? 110 : 255));
    edge->setLineWidth(view.visited ? 1.0F : 2.0F);
  }
}

void SceneLayers::add_ways() const {
  std::vector<Eigen::Vector2d> driven;
  for (const auto& [t, pose] : story_.poses) {
    if (t <= t_s_) driven.push_back(pose.believed.position());
  }
  band(*add<gl::CSetOfTriangles>("driven"), driven, kWay_m, kBlue);
  const auto* wanted = latest(story_.paths, t_s_);
  if (wanted != nullptr) band(*add<gl::CSetOfTriangles>("way"), *wanted, kWanted_m, kYellow);
}

void SceneLayers::add_letter(const std::string& text, const Eigen::Vector3d& p, const Colour& colour) const {
  constexpr int kHeight_px = 26;
  const auto letter = add<gl::CText>(text);
  letter->setString(text);
  letter->setFont("sans", kHeight_px);
  letter->setColor_u8(colour);
  letter->setLocation(p.x(), p.y(), p.z());
}

void SceneLayers::add_regions() const {
  constexpr double kLeast_m = 0.05, kOver_m = 0.1;
  const auto* regions = latest(story_.regions, t_s_);
  for (const StoryRegion& r : regions == nullptr ? std::vector<StoryRegion>() : *regions) {
    if (r.withdrawn) continue;
    const Colour& colour = r.examined ? kBlue : kOrange;
    const double height_m = std::max(kLeast_m, r.z_high_m - r.z_low_m);
    const auto wall = cylinder(r.radius_m, height_m);
    wall->setHasBases(false, false);
    wall->setName("region " + std::to_string(r.id));
    wall->setLocation(r.centre_m.x(), r.centre_m.y(), r.z_low_m);
    wall->setColor_u8(with_alpha(colour, 90));
    scene_.insert(wall);
    add_letter((r.examined ? "E" : "O") + std::to_string(r.id),
               {r.centre_m.x(), r.centre_m.y(), r.z_low_m + height_m + kOver_m}, colour);
  }
  const auto segments = add<gl::CSetOfObjects>("segments");
  for (const auto& [t, list] : story_.segments) {
    if (t > t_s_) break;
    for (const StorySegment& s : list) {
      const auto thing = box(s.size_m.cwiseMax(0.01));
      thing->setWireframe(true);
      thing->setLineWidth(2.0F);
      thing->setColor_u8(kPurple);
      thing->setPose(mrpt::poses::CPose3D(s.centre.p.x(), s.centre.p.y(), s.centre.p.z(), s.yaw_rad, 0.0, 0.0));
      segments->insert(thing);
    }
  }
}

void SceneLayers::add_objects() const {
  constexpr double kFlag_m = 1.7;  // above the walls as the robot maps them
  constexpr float kRadius_m = 0.03F;
  const auto* objects = latest(story_.objects, t_s_);
  for (const StoryObject& o : objects == nullptr ? std::vector<StoryObject>() : *objects) {
    const Colour& colour = o.found ? kGreen : kVermillion;
    const Eigen::Vector3d p = o.place.p, top(p.x(), p.y(), std::max(kFlag_m, p.z() + 0.3));
    const auto ball = gl::CSphere::Create(kRadius_m);
    ball->setName("object " + o.name);
    ball->setLocation(p.x(), p.y(), p.z());
    ball->setColor_u8(colour);
    scene_.insert(ball);
    const auto stem = add<gl::CSetOfLines>("stem of " + o.name);
    stem->appendLine(p.x(), p.y(), p.z(), top.x(), top.y(), top.z() - 0.08);
    stem->setColor_u8(colour);
    add_letter((o.found ? "F " : "M ") + o.name, top, colour);
  }
}

void SceneLayers::add_robot() const {
  const StoryPose pose = pose_at(story_, t_s_);
  const auto robot = add<gl::CSetOfObjects>("robot");
  robot->setPose(pose_of(pose.believed.lift().T));
  for (const StoryRobot::Shape& shape : shapes_at(story_.robot, pose.head)) robot->insert(shown(shape));
}

}  // namespace amiss::page
