#include "dataset/bag_writer.hpp"

#include <bzlib.h>
#include <geometry_msgs/PoseWithCovariance.h>
#include <geometry_msgs/TwistWithCovariance.h>
#include <ros/serialization.h>
#include <roslz4/lz4s.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <cstring>

namespace amiss::test {
namespace {

using Fields = std::vector<std::pair<std::string, std::string>>;

std::string little(std::size_t value) {
  const auto number = static_cast<std::uint32_t>(value);
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &number, 4);
  return bytes;
}

std::string fields(const Fields& all) {
  std::string bytes;
  for (const auto& [name, value] : all) {
    bytes.append(little(name.size() + 1 + value.size())).append(name).append("=").append(value);
  }
  return bytes;
}

std::string record(const Fields& header, const std::string& data) {
  const std::string head = fields(header);
  return little(head.size()) + head + little(data.size()) + data;
}

template <class Message>
std::string serialized(const Message& message) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return {bytes.begin(), bytes.end()};
}

}  // namespace

BagWriter::BagWriter(std::string compression) : compression_(std::move(compression)) {
  bytes_ = "#ROSBAG V2.0\n" + record({{"op", "\x03"}, {"index_pos", std::string(8, '\0')}}, std::string(200, ' '));
}

template <class Message>
void BagWriter::add(const std::string& topic, const Message& message) {
  namespace traits = ros::message_traits;
  add_bytes(
      topic,
      {traits::DataType<Message>::value(), traits::MD5Sum<Message>::value(), traits::Definition<Message>::value()},
      serialized(message));
}

/// `type`: its name, its MD5 sum and its definition.
void BagWriter::add_bytes(const std::string& topic, const std::vector<std::string>& type, const std::string& message) {
  std::string chunk;
  if (connections_.count(topic) == 0) {
    const auto number = static_cast<std::uint32_t>(connections_.size());
    connections_[topic] = number;
    chunk += record(
        {{"op", "\x07"}, {"conn", little(number)}, {"topic", topic}},
        fields({{"topic", topic}, {"type", type.at(0)}, {"md5sum", type.at(1)}, {"message_definition", type.at(2)}}));
  }
  chunk += record({{"op", "\x02"}, {"conn", little(connections_[topic])}, {"time", std::string(8, '\0')}}, message);
  bytes_ += record({{"op", "\x05"}, {"compression", compression_}, {"size", little(chunk.size())}}, packed(chunk));
  bytes_ += record({{"op", "\x04"}, {"ver", little(1)}, {"conn", little(0)}, {"count", little(0)}}, "");
}

std::string BagWriter::packed(std::string chunk) const {
  if (compression_ != "lz4" && compression_ != "bz2") return chunk;
  std::string out(2 * chunk.size() + 4096, '\0');
  auto size = static_cast<unsigned>(out.size());
  if (compression_ == "lz4") {
    roslz4_buffToBuffCompress(chunk.data(), static_cast<unsigned>(chunk.size()), out.data(), &size, 6);
  } else {
    BZ2_bzBuffToBuffCompress(out.data(), &size, chunk.data(), static_cast<unsigned>(chunk.size()), 9, 0, 30);
  }
  out.resize(size);
  return out;
}

void BagWriter::write(const std::string& topic, const BagImage& image) {
  sensor_msgs::Image message;
  message.header.stamp = ros::Time(image.stamp_s);
  message.header.frame_id = image.frame;
  message.width = image.width;
  message.height = image.height;
  message.encoding = image.encoding;
  message.step = image.step;
  message.data = image.data;
  add(topic, message);
}

void BagWriter::write(const std::string& topic, const BagPacked& image) {
  sensor_msgs::CompressedImage message;
  message.header.stamp = ros::Time(image.stamp_s);
  message.header.frame_id = image.frame;
  message.format = image.format;
  message.data.assign(image.data.begin(), image.data.end());
  add(topic, message);
}

void BagWriter::write(const std::string& topic, const BagTransform& transform) {
  geometry_msgs::TransformStamped one;
  one.header.stamp = ros::Time(transform.stamp_s);
  one.header.frame_id = transform.parent;
  one.child_frame_id = transform.child;
  one.transform.translation.x = transform.x_m;
  one.transform.rotation.z = std::sin(transform.yaw_rad / 2.0);
  one.transform.rotation.w = std::cos(transform.yaw_rad / 2.0);
  tf2_msgs::TFMessage message;
  message.transforms.push_back(one);
  add(topic, message);
}

void BagWriter::write(const std::string& topic, const BagCamera& camera) {
  sensor_msgs::CameraInfo message;
  message.width = camera.width;
  message.height = camera.height;
  message.D = {0.1, 0.2};
  message.K[0] = message.K[4] = camera.k_fx;
  message.P[0] = camera.p_fx;
  message.P[5] = camera.p_fy;
  message.P[2] = camera.p_cx;
  message.P[6] = camera.p_cy;
  add(topic, message);
}

void BagWriter::write(const std::string& topic, const BagScan& scan) {
  sensor_msgs::LaserScan message;
  message.header.stamp = ros::Time(scan.stamp_s);
  message.header.frame_id = scan.frame;
  message.angle_min = static_cast<float>(scan.angle_min_rad);
  message.angle_increment = static_cast<float>(scan.angle_step_rad);
  message.range_min = static_cast<float>(scan.min_range_m);
  message.range_max = static_cast<float>(scan.max_range_m);
  message.ranges = scan.ranges_m;
  add(topic, message);
}

void BagWriter::write(const std::string& topic, const BagPose& transform) {
  geometry_msgs::TransformStamped one;
  one.header.stamp = ros::Time(transform.stamp_s);
  one.header.frame_id = transform.parent;
  one.child_frame_id = transform.child;
  one.transform.translation.x = transform.x_m;
  one.transform.translation.y = transform.y_m;
  one.transform.translation.z = transform.z_m;
  one.transform.rotation.x = transform.qx;
  one.transform.rotation.y = transform.qy;
  one.transform.rotation.z = transform.qz;
  one.transform.rotation.w = transform.qw;
  tf2_msgs::TFMessage message;
  message.transforms.push_back(one);
  add(topic, message);
}

/// nav_msgs/Odometry from its parts: Debian's nav_msgs would be one more package for this message alone.
void BagWriter::write_odometry(const std::string& topic, const BagPose& pose) {
  std_msgs::Header header;
  header.stamp = ros::Time(pose.stamp_s);
  header.frame_id = pose.parent;
  geometry_msgs::PoseWithCovariance with_covariance;
  with_covariance.pose.position.x = pose.x_m;
  with_covariance.pose.position.y = pose.y_m;
  with_covariance.pose.position.z = pose.z_m;
  with_covariance.pose.orientation.x = pose.qx;
  with_covariance.pose.orientation.y = pose.qy;
  with_covariance.pose.orientation.z = pose.qz;
  with_covariance.pose.orientation.w = pose.qw;
  add_bytes(topic,
            {"nav_msgs/Odometry", "cd5e73d190d741a2f92e81eda573aca7",
             "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n"
             "geometry_msgs/TwistWithCovariance twist\n"},
            serialized(header) + serialized(pose.child) + serialized(with_covariance) +
                serialized(geometry_msgs::TwistWithCovariance()));
}

}  // namespace amiss::test
