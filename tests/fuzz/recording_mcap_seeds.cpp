#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "fuzz/seeds.hpp"
#include "recording/mcap_writer.hpp"
#include "recording/robot_messages.hpp"
#include "recording/ros_messages.hpp"

namespace amiss::fuzz {

namespace {

robot::Observation some_observation() {
  robot::Observation o;
  o.scan = LaserScan{{}, -1.0, 0.5, 0.05, 30.0, {1.0F, 2.0F}};
  o.frame.emplace().frame = {{}, {2, 2, 5.0, 5.0, 0.5, 0.5}, std::vector<Rgb>(4), std::vector<float>(4, 1.0F)};
  return o;
}

std::string whole_file() {
  const robot::Observation o = some_observation();
  const auto file = std::filesystem::temp_directory_path() / ("amiss_seed_" + std::to_string(::getpid()) + ".mcap");
  recording::McapWriter writer(file, "ros2");
  const auto tell = [&](const char* topic, const char* type, const std::string& message) {
    writer.write(writer.add_channel(topic, "cdr", type, "ros2msg", "int32 a\n"), {}, message);
  };
  tell("/amiss/setup", "amiss_msgs/msg/Setup", recording::setup_message({}));
  writer.attach("params.yaml", "text/plain", "a: 1\n");
  tell("/scan", "sensor_msgs/msg/LaserScan", recording::scan_message(*o.scan));
  tell("/camera/depth/image_raw", "sensor_msgs/msg/Image", recording::depth_message(o.frame->frame));
  tell("/amiss/observation", "amiss_msgs/msg/Observation", recording::observation_message(o));
  writer.close();
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  std::filesystem::remove(file);
  return bytes.str();
}

}  // namespace

std::vector<std::string> valid_inputs() {
  const robot::Observation o = some_observation();
  return {whole_file(),
          recording::observation_message(o),
          recording::setup_message({}),
          recording::scan_message(*o.scan),
          recording::depth_message(o.frame->frame),
          recording::colour_message(o.frame->frame),
          recording::camera_info_message({}, {})};
}

std::vector<std::string> words() { return {std::string(8, '\xff'), std::string(4, '\xff'), "zstd", "\x06", "32FC1"}; }

}  // namespace amiss::fuzz
