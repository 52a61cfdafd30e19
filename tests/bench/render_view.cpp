// Look at a world through the robot's eye: render_view WORLD.sdf X Y Z YAW TILT OUT.png [FOV_DEG [VISIT OBJECTS]]
// The eye stands at (X, Y, Z) m, looks along YAW rad and up by TILT rad (down when negative). With FOV_DEG the picture
// has this horizontal field of view and 1280x960 pixels, else it is the robot's camera. OUT.depth.png holds the depth
// with the sensor's noise, 40 grey levels a metre. TILT below -1.5 is a plan: ceilings (bodies with "ceiling" in their
// name) are hidden. VISIT is a folder with nudges.yaml and objects.yaml, OBJECTS the folder of the catalogue.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "sim/depth_noise.hpp"
#include "sim/renderer.hpp"
#include "sim/scatter.hpp"
#include "world/loader.hpp"
#include "world/nudges.hpp"

namespace {

using namespace amiss;

void save_colour(const std::string& file, const RgbdFrame& frame) {
  cv::Mat picture(frame.intrinsics.height, frame.intrinsics.width, CV_8UC3);
  for (std::size_t i = 0; i < frame.colour.size(); ++i) {
    const Rgb c = frame.colour[i];
    picture.at<cv::Vec3b>(static_cast<int>(i)) = {c.b, c.g, c.r};
  }
  if (!cv::imwrite(file, picture)) throw std::runtime_error("cannot write " + file);
}

void save_depth(const std::string& file, const RgbdFrame& frame) {
  cv::Mat picture(frame.intrinsics.height, frame.intrinsics.width, CV_8UC1);
  for (std::size_t i = 0; i < frame.depth_m.size(); ++i) {
    const float z = frame.depth_m[i];
    picture.at<std::uint8_t>(static_cast<int>(i)) =
        z > 0.0F ? static_cast<std::uint8_t>(std::min(255.0F, z * 40.0F)) : 0;
  }
  if (!cv::imwrite(file, picture)) throw std::runtime_error("cannot write " + file);
}

world::World visited(const world::World& tidy, const std::filesystem::path& visit, const char* objects) {
  const world::Catalogue catalogue = world::load_catalogue({objects});
  world::World world = world::nudged(tidy, world::load_nudges(visit / "nudges.yaml", tidy));
  for (const sim::ScatteredObject& object : sim::load_scatter(visit / "objects.yaml", catalogue)) {
    world.bodies.push_back(catalogue.at(object.kind).body);
    world.bodies.back().pose = object.pose;
  }
  return world;
}

int run(int argc, char** argv) {
  const bool own_lens = argc > 8;
  const world::World tidy = world::load_world(argv[1]);
  const world::World world = argc > 10 ? visited(tidy, argv[9], argv[10]) : tidy;
  for (const std::string& warning : world.warnings) std::fprintf(stderr, "%s\n", warning.c_str());
  const auto number = [&](int i) { return std::atof(argv[i]); };
  const double yaw = number(5), tilt = number(6);
  const CameraIntrinsics lens = own_lens ? sim::pinhole(1280, 960, radians(number(8))) : CameraIntrinsics{};
  const Eigen::Vector3d eye(number(2), number(3), number(4));
  const Eigen::Vector3d ahead(std::cos(tilt) * std::cos(yaw), std::cos(tilt) * std::sin(yaw), std::sin(tilt));
  std::vector<std::size_t> hidden;
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    if (tilt < -1.5 && world.bodies[i].name.find("ceiling") != std::string::npos) hidden.push_back(i);
  sim::Renderer renderer(world);
  sim::RenderedFrame frame = renderer.render(sim::look_at({eye}, {eye + ahead}), lens, sim::start_poses(world),
                                             {.far_m = 60.0, .hidden = hidden});
  RandomStream stream(1, "view");
  const RgbdFrame seen = sim::DepthNoise({}, lens).apply(std::move(frame), {}, stream);
  const std::string out = argv[7];
  save_colour(out, seen);
  save_depth(out.substr(0, out.rfind('.')) + ".depth.png", seen);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 8) {
    std::fprintf(stderr, "render_view WORLD.sdf X Y Z YAW TILT OUT.png [FOV_DEG [VISIT OBJECTS]]\n");
    return 2;
  }
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
