// Bytes against what ROS 2 writes for the same values, laid out by hand; foreign readers check all types (tests/web).
#include "recording/ros_messages.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace amiss::recording {
namespace {

template <class Value>
Value at(const std::string& bytes, std::size_t offset) {
  Value value{};
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

TEST(RosMessages, TextHasLengthTextAndZero) {
  EXPECT_EQ(text_message("hi"), std::string("\0\1\0\0"
                                            "\3\0\0\0"
                                            "hi\0",
                                            11));
}

TEST(RosMessages, AGridIsAlignedFromBehindTheEncapsulation) {
  FloorGrid grid(0.05, {1.0, -2.0}, 3, 2);
  grid.set({1, 0}, Occupancy::kFree);
  grid.set({2, 1}, Occupancy::kOccupied);
  const std::string bytes = grid_message(Stamp{std::chrono::milliseconds(2500)}, grid);
  const std::size_t body = 4;
  EXPECT_EQ(at<std::int32_t>(bytes, body), 2);
  EXPECT_EQ(at<std::uint32_t>(bytes, body + 4), 500000000U);
  EXPECT_EQ(at<std::uint32_t>(bytes, body + 8), 4U) << "length of 'map' with its zero";
  EXPECT_EQ(at<std::int32_t>(bytes, body + 16), 2) << "map_load_time";
  EXPECT_EQ(at<float>(bytes, body + 24), 0.05F);
  EXPECT_EQ(at<std::uint32_t>(bytes, body + 28), 3U);
  EXPECT_EQ(at<std::uint32_t>(bytes, body + 32), 2U);
  EXPECT_EQ(at<double>(bytes, body + 40), 1.0) << "doubles begin at multiples of 8";
  EXPECT_EQ(at<double>(bytes, body + 48), -2.0);
  EXPECT_EQ(at<double>(bytes, body + 88), 1.0) << "w of the orientation";
  EXPECT_EQ(at<std::uint32_t>(bytes, body + 96), 6U);
  const std::string cells(bytes.substr(body + 100));
  EXPECT_EQ(cells, std::string("\xff\0\xff\xff\xff\x64", 6));
}

TEST(RosMessages, ACloudHasItsPointsOneBehindTheOther) {
  const std::vector<Eigen::Vector3f> points{{1, 2, 3}, {4, 5, 6}};
  const std::string bytes = cloud_message({}, points);
  EXPECT_EQ(at<float>(bytes, bytes.size() - 1 - 4), 6.0F);
  EXPECT_EQ(at<float>(bytes, bytes.size() - 1 - 24), 1.0F);
  EXPECT_EQ(bytes.back(), '\1') << "is_dense";
}

TEST(RosMessages, WithdrawnRegionsAreNotShown) {
  knowledge::Knowledge knowledge;
  knowledge.regions.resize(2);
  knowledge.regions[1].withdrawn = true;
  EXPECT_EQ(at<std::uint32_t>(markers_message({}, knowledge), 4), 3U) << "delete all, a cylinder, its number";
}

}  // namespace
}  // namespace amiss::recording
