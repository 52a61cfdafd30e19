#include "recording/run_recorder.hpp"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "recording/internal/decisions.hpp"
#include "recording/robot_messages.hpp"
#include "recording/ros_messages.hpp"
#include "recording/ros_schemas.hpp"

namespace amiss::recording {

namespace {

constexpr Duration kMapPeriod = std::chrono::seconds(2);
constexpr int kJpegQuality = 80;

std::string jpeg_of(const RgbdFrame& frame) {
  const cv::Mat rgb(frame.intrinsics.height, frame.intrinsics.width, CV_8UC3,
                    const_cast<Rgb*>(frame.colour.data()));  // OpenCV has no view of what is const
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  std::vector<unsigned char> bytes;
  cv::imencode(".jpg", bgr, bytes, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  return {bytes.begin(), bytes.end()};
}

std::vector<Eigen::Vector3f> centres(const std::vector<mapping::Voxel>& voxels, double resolution_m) {
  std::vector<Eigen::Vector3f> points;
  for (const mapping::Voxel& v : voxels) {
    points.push_back(((Eigen::Vector3d(v.x, v.y, v.z).array() + 0.5) * resolution_m).matrix().cast<float>());
  }
  return points;
}

}  // namespace

RunRecorder::RunRecorder(const std::filesystem::path& file, const RunSetup& setup, bool threaded)
    : writer_(file, "ros2"),
      model_(*setup.model),
      floor_clearance_m_(setup.floor_clearance_m),
      batches_([this](const auto& batch) { write(batch); }, threaded) {
  for (const auto& [name, bytes] : setup.documents) writer_.attach(name, "application/octet-stream", bytes);
  put("/amiss/setup", "amiss_msgs/msg/Setup", now_,
      setup_message({setup.seed, setup.method, setup.model->T_base_laser}));
  put("/tf_static", "tf2_msgs/msg/TFMessage", now_,
      transforms_message(now_, {{kBaseFrame, kLaserFrame, setup.model->T_base_laser.T}}));
  put("/map", "nav_msgs/msg/OccupancyGrid", now_, grid_message(now_, *setup.floor));
  batches_.hand_over();
}

RunRecorder::~RunRecorder() = default;

ChannelId RunRecorder::channel(const std::string& topic, const std::string& type) {
  const auto known = channels_.find(topic);
  if (known != channels_.end()) return known->second;
  batches_.join();  // the writer is used by one thread at a time
  const ChannelId id = writer_.add_channel(topic, "cdr", type, "ros2msg", ros_schema(type));
  channels_.emplace(topic, id);
  return id;
}

void RunRecorder::put(const char* topic, const char* type, Stamp stamp, std::string message) {
  put_later(topic, type, stamp, [message = std::move(message)] { return message; });
}

void RunRecorder::put_later(const char* topic, const char* type, Stamp stamp, std::function<std::string()> message) {
  batches_.add({channel(topic, type), stamp, std::move(message)});
}

void RunRecorder::record(const robot::Observation& observation) {
  now_ = observation.stamp;
  if (now_ >= next_flush_) {
    while (next_flush_ <= now_) next_flush_ += kBatchPeriod;
    batches_.hand_over();
  }
  if (observation.scan)
    put("/scan", "sensor_msgs/msg/LaserScan", observation.scan->stamp, scan_message(*observation.scan));
  if (observation.frame) record_frame(observation.frame->frame);
  put("/odom", "nav_msgs/msg/Odometry", observation.odometry.stamp, odometry_message(observation.odometry));
  put("/amiss/observation", "amiss_msgs/msg/Observation", now_, observation_message(observation));
  T_odom_base_ = observation.odometry.T_odom_base;
}

void RunRecorder::record_frame(const RgbdFrame& frame) {
  put("/camera/camera_info", "sensor_msgs/msg/CameraInfo", frame.stamp,
      camera_info_message(frame.stamp, frame.intrinsics));
  const auto kept = std::make_shared<const RgbdFrame>(frame);
  put_later("/camera/depth/image_raw", "sensor_msgs/msg/Image", frame.stamp, [kept] { return depth_message(*kept); });
  put_later("/camera/rgb/image_raw/compressed", "sensor_msgs/msg/CompressedImage", frame.stamp,
            [kept] { return colour_jpeg_message(kept->stamp, jpeg_of(*kept)); });
}

void RunRecorder::attach(mission::Sinks& sinks, const knowledge::KnowledgeBase& knowledge,
                         std::function<const mapping::VoxelMap&()> voxels) {
  knowledge_ = &knowledge;
  voxels_ = std::move(voxels);
  internal::tell_decisions(sinks, [this](const char* topic, const char* type, std::string message) {
    put(topic, type, now_, std::move(message));
  });
  internal::chain<mission::StepEvent>(sinks.step, [this](const auto& e) { on_step(e); });
  internal::chain<mission::ExaminationEvent>(sinks.examined, [this](const auto&) { write_knowledge(); });
  internal::chain<mission::DifferenceEvent>(sinks.compared, [this](const auto& e) {
    put("/difference", "sensor_msgs/msg/PointCloud2", now_,
        cloud_message(now_, centres(e.difference->appeared, voxels_().resolution_m())));
  });
  internal::chain<mission::ProgressEvent>(sinks.progress, [this](const auto&) { write_knowledge(); });
  internal::chain<mission::PlanEvent>(
      sinks.planned, [this](const auto& e) { put("/plan", "std_msgs/msg/String", now_, text_message(e.plan_text)); });
  internal::chain<mission::PathEvent>(sinks.path, [this](const auto& e) {
    put("/path", "nav_msgs/msg/Path", now_, path_message(now_, e.path->points_m));
  });
}

void RunRecorder::log(Stamp stamp, const std::string& text) {
  put("/rosout", "rcl_interfaces/msg/Log", stamp, log_message(stamp, text));
}

void RunRecorder::on_step(const mission::StepEvent& event) {
  Eigen::Isometry3d T_map_odom = (event.pose.T_map_base * T_odom_base_.inverse()).lift().T;
  T_map_odom.pretranslate(Eigen::Vector3d(0.0, 0.0, -floor_clearance_m_));
  put("/tf", "tf2_msgs/msg/TFMessage", now_,
      transforms_message(now_, {{kMapFrame, kOdomFrame, T_map_odom},
                                {kOdomFrame, kBaseFrame, T_odom_base_.lift().T},
                                {kBaseFrame, kCameraFrame, model_.T_base_camera(event.head).T}}));
  if (now_ < next_map_) return;
  while (next_map_ <= now_) next_map_ += kMapPeriod;
  write_map();
}

void RunRecorder::write_map() {
  const mapping::VoxelMap& map = voxels_();
  if (map.revision() == told_revision_) return;
  told_revision_ = map.revision();
  put("/voxels", "sensor_msgs/msg/PointCloud2", now_,
      cloud_message(now_, centres(map.voxels(Occupancy::kOccupied), map.resolution_m())));
}

void RunRecorder::write_knowledge() {
  std::string markers = markers_message(Stamp{}, knowledge_->now());
  if (markers == told_markers_) return;
  told_markers_ = std::move(markers);
  put("/regions", "visualization_msgs/msg/MarkerArray", now_, markers_message(now_, knowledge_->now()));
}

void RunRecorder::write(const std::vector<Pending>& batch) {
  for (const Pending& p : batch) writer_.write(p.channel, p.stamp, p.message());
  writer_.flush();
}

void RunRecorder::close() {
  write_map();
  batches_.hand_over();
  batches_.join();
  writer_.close();
}

}  // namespace amiss::recording
