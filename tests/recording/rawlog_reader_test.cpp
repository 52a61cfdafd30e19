// What MRPT wrote, read by a parser that does not believe it.
#include "recording/rawlog_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/result.hpp"
#include "recording/small_rawlog.hpp"

namespace amiss::recording {
namespace {

std::vector<RawlogObject> objects(RawlogReader& reader) {
  std::vector<RawlogObject> all;
  while (auto object = reader.next()) all.push_back(std::move(*object));
  return all;
}

std::string why(const std::filesystem::path& file) {
  return test::sentence_of<InputError>([&] {
    RawlogReader reader(file);
    objects(reader);
  });
}

TEST(RawlogReader, ReadsScansAndFramesThatMrptWrote) {
  const test::TemporaryFolder folder;
  RawlogReader reader(test::small_rawlog(folder, 2, false));
  const auto all = objects(reader);
  EXPECT_TRUE(reader.complete());
  ASSERT_EQ(all.size(), 5U);
  const auto& odometry = std::get<RawlogOdometry>(all[0]);
  EXPECT_EQ(odometry.stamp, Stamp(std::chrono::milliseconds(100)));
  EXPECT_EQ(odometry.T_odom_base.x_m, 0.1);
  EXPECT_NEAR(odometry.T_odom_base.yaw_rad, 0.3, 1e-12);
  const auto& scan = std::get<RawlogScan>(all[1]);
  ASSERT_EQ(scan.ranges_m.size(), 3U);
  EXPECT_EQ(scan.ranges_m[0], 1.0F / 3.0F);
  EXPECT_TRUE(std::isnan(scan.ranges_m[1]));
  const auto& frame = std::get<RawlogFrame>(all[4]);
  EXPECT_EQ(frame.camera, (CameraIntrinsics{4, 2, 5.125, 5.0, 1.5, 0.5}));
  EXPECT_EQ(frame.stamp, Stamp(std::chrono::milliseconds(200)));
  EXPECT_EQ(frame.depth_unit_m, 0.001F);
  EXPECT_FALSE(frame.along_rays);
  const Transform<Base, Camera> T_base_camera = test::rawlog_observation(2).frame->T_base_camera;
  EXPECT_TRUE(frame.T_base_camera.T.isApprox(T_base_camera.T, 1e-12)) << frame.T_base_camera.T.matrix();
  EXPECT_TRUE(frame.T_camera_colour.isApprox(Eigen::Isometry3d::Identity(), 1e-12)) << "one camera";
  ASSERT_TRUE(frame.colour);
  EXPECT_TRUE(frame.colour->is_jpeg);
  EXPECT_EQ(frame.depth, (std::vector<std::uint16_t>{1234, 0, 133, 65000, 0, 0, 0, 0}));
}

TEST(RawlogReader, ReadsDataByItsName) {
  const test::TemporaryFolder folder;
  RawlogReader reader(test::small_rawlog(folder, 2, true));
  const auto all = objects(reader);
  const auto& document = std::get<RawlogData>(all.at(1));
  EXPECT_EQ(document.label, "/amiss/documents/params.yaml");
  EXPECT_EQ(document.bytes, "a: 1\n");
  const auto& depth = std::get<RawlogData>(all.at(8));
  EXPECT_EQ(depth.label, "/amiss/depth");
  EXPECT_EQ(depth.numbers.size(), 8U);
}

TEST(RawlogReader, AFileThatBreaksOffIsReadUpToThere) {
  const test::TemporaryFolder folder;
  const std::string whole = test::unpacked(test::small_rawlog(folder, 2, false));
  const auto packed = folder.read("a.rawlog");
  RawlogReader first(folder.write("packed.rawlog", std::string_view(packed).substr(0, packed.size() - 12)));
  EXPECT_GE(objects(first).size(), 3U);
  EXPECT_FALSE(first.complete());
  RawlogReader second(folder.write("plain.rawlog", std::string_view(whole).substr(0, whole.size() - 1)));
  EXPECT_EQ(objects(second).size(), 4U);
  EXPECT_FALSE(second.complete());
  EXPECT_FALSE(second.next());
  EXPECT_FALSE(second.complete());
}

TEST(RawlogReader, SaysWhatIsWrong) {
  const test::TemporaryFolder folder;
  const std::string whole = test::unpacked(test::small_rawlog(folder, 2, false));
  EXPECT_NE(why(folder.path() / "none.rawlog").find("there is no such file"), std::string::npos);
  EXPECT_NE(why(folder.write("b", "nothing of this kind")).find("b: object at byte 0 (unpacked): is no object of MRPT"),
            std::string::npos);
  std::string other = whole;
  other.replace(other.find("Odometry"), 8, "Odometer");
  EXPECT_NE(why(folder.write("c", other)).find("a mrpt::obs::CObservationOdometer of version 2 is not read"),
            std::string::npos);
  const std::string old = "\x8d" + std::string("CSensoryFrame\2");
  EXPECT_NE(why(folder.write("f", old)).find("a CSensoryFrame of version 2 is not read"), std::string::npos);
  std::string longer = whole;
  longer[longer.find("CImage") + 6] = 8;
  EXPECT_NE(why(folder.write("d", longer)).find("has no mrpt::img::CImage where it should"), std::string::npos);
  std::string packed = folder.read("a.rawlog");
  packed[packed.size() - 6] = static_cast<char>(packed[packed.size() - 6] ^ 1);  // of the CRC
  EXPECT_NE(why(folder.write("e", packed)).find("its packed data was damaged"), std::string::npos);
}

}  // namespace
}  // namespace amiss::recording
