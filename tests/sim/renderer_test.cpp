#include "sim/renderer.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <future>

#include "core/random.hpp"
#include "core/result.hpp"
#include "sim/camera_fixture.hpp"

namespace amiss::sim {
namespace {

/// Ray of a pixel in the camera frame, z = 1.
Eigen::Vector3d ray_of(const CameraIntrinsics& c, int u, int v) { return {(u - c.cx) / c.fx, (v - c.cy) / c.fy, 1.0}; }

RenderedFrame shot(const world::World& world, const Transform<amiss::World, Camera>& eye,
                   const CameraIntrinsics& c = {}) {
  return Renderer(world).render(eye, c, start_poses(world));
}

TEST(Renderer, DepthOfATiltedFloorIsExactAtEveryPixel) {
  world::World world;
  world.bodies.push_back(coloured_body("floor", world::Plane{{0, 0, 1}, {60, 60}}, {0, 0, 0}, kWhite));
  const CameraIntrinsics c;
  const auto eye = eye_at(0.97, 0.55);
  const RenderedFrame frame = shot(world, eye, c);
  int seen = 0;
  for (int v = 0; v < c.height; v += 7)
    for (int u = 0; u < c.width; u += 7) {
      const Eigen::Vector3d ray = eye.T.linear() * ray_of(c, u, v);
      const float depth = frame.depth_m[pixel(c, u, v)];
      if (ray.z() > -0.05) continue;
      const double expected = 0.97 / -ray.z();
      ASSERT_NEAR(depth, expected, 2e-4 * expected) << u << " " << v;
      ASSERT_NEAR(frame.incidence[pixel(c, u, v)], 255.0 * -ray.z() / ray.norm(), 1.0);
      ++seen;
    }
  EXPECT_GT(seen, 4000);
}

TEST(Renderer, DepthAndIncidenceOfASphereMatchTheEquation) {
  world::World world;
  world.bodies.push_back(coloured_body("ball", world::Sphere{0.5}, {3, 0, 1}, kRed));
  const CameraIntrinsics c;
  const auto eye = eye_at(1.0);
  const RenderedFrame frame = shot(world, eye, c);
  const Eigen::Vector3d centre = eye.inverse().T * Eigen::Vector3d(3, 0, 1);
  for (int v = 200; v < 270; v += 5)
    for (int u = 270; u < 360; u += 5) {
      const Eigen::Vector3d d = ray_of(c, u, v).normalized();
      const double along = d.dot(centre), below = along * along - centre.squaredNorm() + 0.25;
      ASSERT_GT(below, 0.0);
      const Eigen::Vector3d hit = d * (along - std::sqrt(below));
      EXPECT_NEAR(frame.depth_m[pixel(c, u, v)], hit.z(), 0.006);  // the sphere has facets
      EXPECT_NEAR(frame.incidence[pixel(c, u, v)] / 255.0, -d.dot((hit - centre) / 0.5), 0.03);
      EXPECT_EQ(frame.instances[pixel(c, u, v)], 1);
    }
}

TEST(Renderer, EdgesOfABoxLieAtTheProjectedPixels) {
  world::World world;  // the near face is x = 2, y in [-0.3, 0.3], z in [0.8, 1.2]
  world.bodies.push_back(coloured_body("box", world::Box{{1.0, 0.6, 0.4}}, {2.5, 0, 1}, kGreen));
  const CameraIntrinsics c;
  const RenderedFrame frame = shot(world, eye_at(1.0), c);
  const int left = static_cast<int>(std::ceil(c.cx - 0.15 * c.fx)),
            right = static_cast<int>(std::floor(c.cx + 0.15 * c.fx));
  const int top = static_cast<int>(std::ceil(c.cy - 0.1 * c.fy)), low = static_cast<int>(std::floor(c.cy + 0.1 * c.fy));
  for (int v = 0; v < c.height; ++v)
    for (int u = 0; u < c.width; ++u) {
      const bool inside = u >= left && u <= right && v >= top && v <= low;
      ASSERT_EQ(frame.instances[pixel(c, u, v)] == 1, inside) << u << " " << v;
      ASSERT_EQ(std::isnan(frame.depth_m[pixel(c, u, v)]), !inside);
      if (inside) {
        ASSERT_NEAR(frame.depth_m[pixel(c, u, v)], 2.0F, 1e-4F);
      }
    }
}

TEST(Renderer, LeftIsLeftAndUpIsUp) {
  world::World world;
  world.bodies.push_back(coloured_body("left", world::Box{{0.2, 0.2, 0.2}}, {2, 0.5, 1}, kRed));  // +y is left
  world.bodies.push_back(coloured_body("right", world::Box{{0.2, 0.2, 0.2}}, {2, -0.5, 1}, kGreen));
  world.bodies.push_back(coloured_body("up", world::Box{{0.2, 0.2, 0.2}}, {2, 0, 1.5}, kBlue));
  const CameraIntrinsics c;
  const RenderedFrame frame = shot(world, eye_at(1.0), c);
  EXPECT_EQ(frame.instances[pixel(c, 170, 233)], 1);
  EXPECT_EQ(frame.instances[pixel(c, 460, 233)], 2);
  EXPECT_EQ(frame.instances[pixel(c, 315, 90)], 3);
  EXPECT_EQ(frame.instances[pixel(c, 315, 376)], 0);
  const Rgb left = frame.colour[pixel(c, 170, 233)], up = frame.colour[pixel(c, 315, 90)];
  EXPECT_GT(left.r, 2 * left.g);
  EXPECT_GT(up.b, 2 * up.r);
}

std::shared_ptr<const world::Texture> four_quarters() {  // red green / blue white, row 0 on top
  auto texture = std::make_shared<world::Texture>();
  texture->width = texture->height = 32;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      texture->pixels.push_back(y < 16 ? (x < 16 ? Rgb{255, 0, 0} : Rgb{0, 255, 0})
                                       : (x < 16 ? Rgb{0, 0, 255} : Rgb{255, 255, 255}));
  return texture;
}

TEST(Renderer, TexturesStandUprightAndAreNotMirrored) {
  world::World world;
  world.bodies.push_back(coloured_body("poster", world::Box{{0.1, 1, 1}}, {2, 0, 1}, {1, 1, 1}));
  world.bodies[0].visuals[0].material.texture = four_quarters();
  const CameraIntrinsics c;
  const RenderedFrame frame = shot(world, eye_at(1.0), c);
  const Rgb a = frame.colour[pixel(c, 260, 180)], b = frame.colour[pixel(c, 370, 180)],
            d = frame.colour[pixel(c, 260, 290)], e = frame.colour[pixel(c, 370, 290)];
  EXPECT_TRUE(a.r > 100 && a.g < 20 && a.b < 20);
  EXPECT_TRUE(b.g > 100 && b.r < 20 && b.b < 20);
  EXPECT_TRUE(d.b > 100 && d.r < 20 && d.g < 20);
  EXPECT_TRUE(e.r > 100 && e.g > 100 && e.b > 100);
  EXPECT_GT(frame.reflectance[pixel(c, 370, 290)], 2 * frame.reflectance[pixel(c, 260, 180)]);
}

TEST(Renderer, AnOpenMeshIsSeenFromBothSidesAndAClosedOneOnce) {
  auto sheet = std::make_shared<world::Mesh>();
  sheet->vertices = {{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}};
  sheet->indices = {0, 1, 2, 0, 2, 3};
  for (const double turn : {0.0, std::numbers::pi}) {
    world::World world;
    world.bodies.push_back(coloured_body("sheet", world::MeshInstance{sheet, {1, 1, 1}}, {2, 0, 1}, kRed));
    world.bodies[0].pose.T.rotate(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()));
    const CameraIntrinsics c;
    const RenderedFrame frame = shot(world, eye_at(1.0), c);
    EXPECT_NEAR(frame.depth_m[pixel(c, 315, 233)], 2.0F, 1e-4F);
    EXPECT_GT(frame.colour[pixel(c, 315, 233)].r, 80);
  }
}

TEST(Renderer, TheDepthCameraSeesThroughGlass) {
  world::World world;
  world.bodies.push_back(coloured_body("wall", world::Box{{0.1, 4, 4}}, {3.05, 0, 1}, kWhite));
  const RenderedFrame bare = shot(world, eye_at(1.0));
  world.bodies.push_back(coloured_body("pane", world::Box{{0.01, 4, 4}}, {2, 0, 1}, kBlue));
  world.bodies[1].visuals[0].material.alpha = 0.5F;
  const CameraIntrinsics c;
  const RenderedFrame frame = shot(world, eye_at(1.0), c);
  const std::size_t middle = pixel(c, 320, 240);
  EXPECT_NEAR(frame.depth_m[middle], 3.0F, 1e-4F);
  EXPECT_EQ(frame.instances[middle], 1);
  EXPECT_LT(frame.colour[middle].r, bare.colour[middle].r - 30);
}

world::World crowd() {
  world::World world;
  RandomStream random(7, "crowd");
  const auto texture = four_quarters();
  for (int i = 0; i < 120; ++i) {
    const Eigen::Vector3d at(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(0, 2));
    const double size = random.uniform(0.05, 0.6);
    const world::Geometry shapes[] = {world::Box{{size, size / 2, size}}, world::Cylinder{size / 2, size},
                                      world::Sphere{size / 2}};
    world.bodies.push_back(coloured_body("thing", shapes[i % 3], at, i % 2 == 0 ? kRed : kBlue));
    if (i % 5 == 0) world.bodies.back().visuals[0].material.texture = texture;
  }
  return world;
}

TEST(Renderer, CullingDoesNotChangeThePicture) {
  const world::World world = crowd();
  Renderer renderer(world);
  const auto poses = start_poses(world);
  for (int i = 0; i < 12; ++i) {
    const auto eye = look_at({{0.3 * i - 2, 0.2 * i - 1, 1.0}}, {{std::cos(i), std::sin(i), 0.8 + 0.05 * i}});
    const RenderedFrame a = renderer.render(eye, {}, poses), b = renderer.render(eye, {}, poses, {.cull = false});
    ASSERT_EQ(a.instances, b.instances) << i;
    ASSERT_EQ(a.colour, b.colour) << i;
    for (std::size_t k = 0; k < a.depth_m.size(); ++k)
      ASSERT_TRUE(a.depth_m[k] == b.depth_m[k] || (std::isnan(a.depth_m[k]) && std::isnan(b.depth_m[k])));
  }
}

TEST(Renderer, OtherThreadsAndOtherRenderersDrawTheSame) {
  const world::World world = crowd();
  Renderer first(world), second(world);
  const auto poses = start_poses(world);
  const RenderedFrame here = first.render(eye_at(1.0), {}, poses);
  auto a = std::async(std::launch::async, [&] { return first.render(eye_at(1.0), {}, poses); });
  auto b = std::async(std::launch::async, [&] { return second.render(eye_at(1.0), {}, poses); });
  EXPECT_EQ(here.colour, a.get().colour);
  EXPECT_EQ(here.instances, b.get().instances);
}

TEST(Renderer, BodiesComeMoveHideAndGo) {
  world::World world;
  world.bodies.push_back(coloured_body("wall", world::Box{{0.1, 4, 4}}, {3.05, 0, 1}, kWhite));
  Renderer renderer(world);
  auto poses = start_poses(world);
  const world::Body ball = coloured_body("ball", world::Sphere{0.2}, {0, 0, 0}, kRed);
  const std::size_t index = renderer.add_body(ball);
  poses.push_back({});
  poses[index].T.translation() = Eigen::Vector3d(2, 0, 1);
  const CameraIntrinsics c;
  const std::size_t middle = pixel(c, 315, 233);
  EXPECT_EQ(renderer.render(eye_at(1.0), c, poses).instances[middle], 2);
  const std::size_t hidden[] = {index};
  EXPECT_EQ(renderer.render(eye_at(1.0), c, poses, {.hidden = hidden}).instances[middle], 1);
  poses[index].T.translation().y() = 1.0;
  EXPECT_EQ(renderer.render(eye_at(1.0), c, poses).instances[middle], 1);
  renderer.keep_bodies(1);
  EXPECT_THROW((void)renderer.render(eye_at(1.0), c, poses), ArgumentError);
  poses.pop_back();
  EXPECT_EQ(renderer.render(eye_at(1.0), c, poses).instances[middle], 1);
}

TEST(Renderer, ImpossibleCamerasAreRefused) {
  Renderer renderer{world::World{}};
  EXPECT_THROW((void)renderer.render({}, {0, 480, 500, 500, 0, 0}, {}), ArgumentError);
  EXPECT_THROW((void)renderer.render({}, {640, 480, -1, 500, 0, 0}, {}), ArgumentError);
  EXPECT_THROW((void)renderer.render({}, {}, {}, {.near_m = 2.0, .far_m = 1.0}), ArgumentError);
}

RC_GTEST_PROP(LookAt, TheTargetLiesInTheMiddleAndTheWorldStandsUpright, ()) {
  const auto number = [] { return *rc::gen::inRange(-500, 500) / 100.0; };
  const Eigen::Vector3d eye(number(), number(), number()), target(number(), number(), number());
  RC_PRE((target - eye).norm() > 0.01);
  const auto T = look_at({eye}, {target});
  const Eigen::Vector3d seen = T.inverse().T * target;
  RC_ASSERT(seen.head<2>().norm() < 1e-9);
  RC_ASSERT(seen.z() > 0.0);
  RC_ASSERT(std::abs(T.T.linear().determinant() - 1.0) < 1e-9);
  RC_ASSERT(T.T.linear().col(1).z() < 1e-9);  // y of the picture points down
}

TEST(Renderer, TellsWhoDraws) { EXPECT_NE(opengl_version().find(", OpenGL "), std::string::npos) << opengl_version(); }

}  // namespace
}  // namespace amiss::sim
