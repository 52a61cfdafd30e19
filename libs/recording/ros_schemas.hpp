// The definitions of the ROS 2 messages that are written, as their packages have them (Humble), without comments; and
// those of our own, amiss_msgs, that a replay needs.
#pragma once

#include <string>

namespace amiss::recording {

/// "nav_msgs/msg/Odometry" -> its definition, followed by all that it needs, as MCAP's "ros2msg" wants it.
/// std::logic_error for a type that is not here.
[[nodiscard]] std::string ros_schema(const std::string& type);

}  // namespace amiss::recording
