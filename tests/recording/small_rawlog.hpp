// A rawlog as a RawlogWriter makes it: some periods with a scan each, every second one with a frame of odd depths.
#pragma once

#include <array>
#include <cstdio>
#include <limits>
#include <memory>

#include "core/temporary_folder.hpp"
#include "recording/rawlog_writer.hpp"

namespace amiss::test {

inline robot::Observation rawlog_observation(int period) {
  constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
  robot::Observation o;
  o.stamp = Stamp{std::chrono::milliseconds(100) * period};
  o.odometry = {o.stamp, {0.1 * period, 0.2, 0.3}};
  o.head = {0.25, -0.5};
  o.scan = LaserScan{o.stamp, -1.0, 0.5, 0.05, 30.0, {1.0F / 3.0F, kNothing, static_cast<float>(period)}};
  if (period % 2 != 0) return o;
  auto& [frame, T_base_camera, T_odom_base] = o.frame.emplace();
  frame = {o.stamp, {4, 2, 5.125, 5.0, 1.5, 0.5}, std::vector<Rgb>(8, Rgb{200, 100, 50}), {}};
  frame.depth_m = {1.2344321F, kNothing, 0.4F / 3.0F, 64.9999F, 70.5F, -1.0F, 0.0F, 1e-9F};
  T_base_camera.T.translation().z() = 1.0 / 3.0;
  T_odom_base = o.odometry.T_odom_base;
  return o;
}

/// What a mission did after all periods: compared, and segmented one region.
inline void tell_rawlog_decisions(const mission::Sinks& sinks, const RgbdFrame& frame) {
  sinks.compared({});
  sinks.segmenting({&frame, {}});
  mission::ExaminationEvent examined;
  examined.region = 7;
  sinks.examined(examined);
}

inline std::filesystem::path small_rawlog(const TemporaryFolder& folder, int periods, bool for_replay) {
  const auto file = folder.path() / "a.rawlog";
  robot::Model model;
  model.T_base_laser.T.translation() = Eigen::Vector3d(0.2, 0.0, 0.18);
  recording::RunSetup setup{5, "dynamic", 0.012, &model, nullptr, {{"params.yaml", "a: 1\n"}}};
  auto writer = for_replay ? std::make_unique<recording::RawlogWriter>(file, setup, true)
                           : std::make_unique<recording::RawlogWriter>(file, model.T_base_laser, true);
  mission::Sinks sinks;
  if (for_replay) writer->attach(sinks);
  for (int period = 1; period <= periods; ++period) writer->record(rawlog_observation(period));
  if (for_replay) tell_rawlog_decisions(sinks, rawlog_observation(2).frame->frame);
  writer->close();
  return file;
}

/// A file's bytes without their gzip.
inline std::string unpacked(const std::filesystem::path& file) {
  std::string bytes;
  std::array<char, 4096> buffer{};
  FILE* pipe = ::popen(("gzip -dc '" + file.string() + "'").c_str(), "r");
  for (std::size_t got = 0; (got = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
    bytes.append(buffer.data(), got);
  }
  EXPECT_EQ(::pclose(pipe), 0);
  return bytes;
}

}  // namespace amiss::test
