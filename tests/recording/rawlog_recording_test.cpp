// What a rawlog gives a replay is what the robot said, to the last bit.
#include "recording/rawlog_recording.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "core/result.hpp"
#include "recording/ros_messages.hpp"
#include "recording/small_rawlog.hpp"

namespace amiss::recording {
namespace {

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

TEST(RawlogRecording, ObservationsComeBackToTheLastBit) {
  const test::TemporaryFolder folder;
  RawlogRecording recording(test::small_rawlog(folder, 4, true));
  EXPECT_EQ(recording.setup().seed, 5U);
  EXPECT_EQ(recording.setup().T_base_laser.position(), Eigen::Vector3d(0.2, 0.0, 0.18));
  EXPECT_EQ(recording.documents().at("params.yaml"), "a: 1\n");
  for (int period = 1; period <= 4; ++period) {
    const robot::Observation said = test::rawlog_observation(period);
    const auto entry = recording.next();
    ASSERT_TRUE(entry);
    const auto& read = std::get<robot::Observation>(*entry);
    EXPECT_EQ(observation_message(read), observation_message(said));
    EXPECT_TRUE(same_bits(read.scan->ranges_m, said.scan->ranges_m));
    ASSERT_EQ(read.frame.has_value(), period % 2 == 0);
    if (!read.frame) continue;
    EXPECT_TRUE(same_bits(read.frame->frame.depth_m, said.frame->frame.depth_m));
    EXPECT_EQ(read.frame->frame.intrinsics, said.frame->frame.intrinsics);
  }
}

TEST(RawlogRecording, DecisionsStandWhereTheyWereMade) {
  const test::TemporaryFolder folder;
  RawlogRecording recording(test::small_rawlog(folder, 1, true));
  ASSERT_TRUE(recording.next());
  EXPECT_EQ(std::get<Decision>(recording.next().value()).kind, Decision::Kind::kCompared);
  const auto segmenting = std::get<Segmenting>(recording.next().value());
  EXPECT_EQ(segmenting.colour_message, colour_message(test::rawlog_observation(2).frame->frame));
  const auto examined = std::get<Decision>(recording.next().value());
  EXPECT_EQ(examined.kind, Decision::Kind::kExamined);
  EXPECT_EQ(examined.region, 7);
  EXPECT_FALSE(recording.next());
  EXPECT_TRUE(recording.complete());
}

TEST(RawlogRecording, ARawlogWithoutWhatAReplayNeedsIsRefused) {
  const test::TemporaryFolder folder;
  const auto file = test::small_rawlog(folder, 2, false);
  const std::string said = test::sentence_of<InputError>([&] { RawlogRecording recording(file); });
  EXPECT_NE(said.find("a.rawlog: does not hold what a replay needs"), std::string::npos) << said;
}

TEST(RawlogRecording, AnObservationWithoutItsScanIsRefused) {
  const test::TemporaryFolder folder;
  std::string bytes = test::unpacked(test::small_rawlog(folder, 1, true));
  const std::string scan = "\xa2mrpt::obs::CObservation2DRangeScan", data = "\x9dmrpt::obs::CObservationRawDAQ";
  const std::size_t begin = bytes.find(scan), end = bytes.find(data, begin);
  ASSERT_NE(end, std::string::npos);
  bytes.erase(begin, end - begin);
  RawlogRecording recording(folder.write("b.rawlog", bytes));
  const std::string said = test::sentence_of<InputError>([&] { (void)recording.next(); });
  EXPECT_NE(said.find("b.rawlog: /amiss/observation: the scan of an observation is missing"), std::string::npos)
      << said;
}

}  // namespace
}  // namespace amiss::recording
