// How fast the camera is: camera_bench [WORLD.sdf X Y]. Turns at (X, Y) in the world, or in a furnished room of about
// 100 000 triangles made here; 640x480, one thread. Prints milliseconds of processor time.
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "sim/camera_fixture.hpp"
#include "sim/depth_noise.hpp"
#include "world/loader.hpp"

namespace {

using namespace amiss;
using sim::coloured_body;

std::shared_ptr<const world::Texture> boards() {
  auto texture = std::make_shared<world::Texture>();
  texture->width = texture->height = 256;
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) {
      const auto shade = static_cast<std::uint8_t>(150 + (x * 7 + (y / 32) * 53) % 60);
      texture->pixels.push_back(
          {shade, static_cast<std::uint8_t>(shade * 3 / 4), static_cast<std::uint8_t>(shade / 2)});
    }
  return texture;
}

world::World furnished_room() {
  world::World room;
  room.bodies.push_back(coloured_body("floor", world::Box{{10, 8, 0.1}}, {0, 0, -0.05}, {1, 1, 1}));
  room.bodies.back().visuals[0].material.texture = boards();
  for (const double side : {-1.0, 1.0}) {
    room.bodies.push_back(coloured_body("wall", world::Box{{10, 0.1, 2.5}}, {0, 4.05 * side, 1.25}, {0.9F, 0.88F, 0.8F}));
    room.bodies.push_back(coloured_body("wall", world::Box{{0.1, 8, 2.5}}, {5.05 * side, 0, 1.25}, {0.85F, 0.9F, 0.88F}));
  }
  RandomStream random(1, "bench");
  for (int i = 0; i < 150; ++i) {
    const Eigen::Vector3d at(random.uniform(-4.8, 4.8), random.uniform(-3.8, 3.8), random.uniform(0.1, 1.5));
    const Eigen::Vector3f colour = Eigen::Vector3d(random.uniform(), random.uniform(), random.uniform()).cast<float>();
    room.bodies.push_back(coloured_body("ball", world::Sphere{random.uniform(0.03, 0.1)}, at, colour));
    room.bodies.push_back(
        coloured_body("can", world::Cylinder{random.uniform(0.02, 0.1), 0.3}, -at + Eigen::Vector3d(0, 0, 1.6), colour));
    world::Body table = coloured_body("table", world::Box{{0.5, 0.3, 0.03}}, {at.y() * 1.2, at.x() * 0.8, 0.4}, colour);
    for (int leg = 0; leg < 4; ++leg) {
      world::Shape shape = table.visuals[0];
      shape.geometry = world::Cylinder{0.02, 0.4};
      shape.T_body_shape.translation() = Eigen::Vector3d(leg % 2 ? 0.2 : -0.2, leg / 2 ? 0.12 : -0.12, -0.2);
      table.visuals.push_back(shape);
    }
    room.bodies.push_back(table);
  }
  for (world::Body& body : room.bodies)
    if (body.name == "ball") body.visuals[0].geometry = world::Sphere{0.1};
  return room;
}

Transform<World, Camera> view(int i, const Eigen::Vector3d& middle) {
  const double angle = 0.1 * i;
  const Eigen::Vector3d eye = middle + Eigen::Vector3d(0.5 * std::cos(angle * 0.3), 0.5 * std::sin(angle * 0.3), 0.97);
  const Eigen::Vector3d ahead(std::cos(angle), std::sin(angle), -0.5);
  return sim::look_at({eye}, {eye + ahead});
}

/// Processor time, so that neighbours on the machine do not count.
template <class Work>
double ms_each(int rounds, Work work) {
  const std::clock_t start = std::clock();
  for (int i = 0; i < rounds; ++i) work(i);
  return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / rounds;
}

void measure(const world::World& room, const Eigen::Vector3d& middle) {
  constexpr int kRounds = 200;
  const auto poses = sim::start_poses(room);
  sim::Renderer renderer(room);
  const CameraIntrinsics intrinsics;
  const double culled = ms_each(kRounds, [&](int i) { (void)renderer.render(view(i, middle), intrinsics, poses); });
  const double whole =
      ms_each(kRounds, [&](int i) { (void)renderer.render(view(i, middle), intrinsics, poses, {.cull = false}); });
  const double empty = ms_each(kRounds, [&](int) { (void)renderer.render(view(0, {0, 0, 90}), intrinsics, poses); });
  std::printf("render %.2f ms (%.0f fps), without culling %.2f ms, nothing in view %.2f ms\n", culled, 1000.0 / culled,
              whole, empty);

  const sim::DepthNoise noise({}, intrinsics);
  RandomStream random(1, "noise");
  const sim::RenderedFrame frame = renderer.render(view(0, middle), intrinsics, poses);
  std::size_t size = 0;
  const double copied = ms_each(kRounds, [&](int) {
    auto copy = frame;
    size += copy.colour.size();
  });
  const double noised = ms_each(kRounds, [&](int) {
    auto copy = frame;
    size += noise.apply(std::move(copy), {}, random).colour.size();
  });
  std::printf("noise %.2f ms (%zu pixels in all)\n", noised - copied, size);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 1 && argc != 4) {
    std::fprintf(stderr, "camera_bench [WORLD.sdf X Y]\n");
    return 2;
  }
  if (argc == 4)
    measure(world::load_world(argv[1]), {std::atof(argv[2]), std::atof(argv[3]), 0.0});
  else
    measure(furnished_room(), {0, 0, 0});
  return 0;
}
