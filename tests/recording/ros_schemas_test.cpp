#include "recording/ros_schemas.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace amiss::recording {
namespace {

TEST(RosSchemas, EachNeededTypeStandsInThemOnce) {
  const std::string text = ros_schema("nav_msgs/msg/Odometry");
  const std::string rule(80, '=');
  EXPECT_EQ(text.rfind("std_msgs/Header header\n", 0), 0U);
  for (const char* type : {"std_msgs/Header", "builtin_interfaces/Time", "geometry_msgs/PoseWithCovariance",
                           "geometry_msgs/Vector3", "geometry_msgs/Quaternion"}) {
    const std::string head = rule + "\nMSG: " + type + "\n";
    const auto at = text.find(head);
    EXPECT_NE(at, std::string::npos) << type;
    EXPECT_EQ(text.find(head, at + 1), std::string::npos) << type << " stands there twice";
  }
}

TEST(RosSchemas, AnUnknownTypeIsABug) { EXPECT_THROW((void)ros_schema("x/msg/Y"), std::logic_error); }

}  // namespace
}  // namespace amiss::recording
