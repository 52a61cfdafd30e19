#include "recording/ros_schemas.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace amiss::recording {

namespace {

/// By package and name.
const std::map<std::string, std::string>& definitions() {
  static const std::map<std::string, std::string> all{
      {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
      {"builtin_interfaces/Duration", "int32 sec\nuint32 nanosec\n"},
      {"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"},
      {"std_msgs/String", "string data\n"},
      {"std_msgs/ColorRGBA", "float32 r\nfloat32 g\nfloat32 b\nfloat32 a\n"},
      {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
      {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
      {"geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"},
      {"geometry_msgs/Pose", "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
      {"geometry_msgs/PoseStamped", "std_msgs/Header header\ngeometry_msgs/Pose pose\n"},
      {"geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose pose\nfloat64[36] covariance\n"},
      {"geometry_msgs/Twist", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n"},
      {"geometry_msgs/TwistWithCovariance", "geometry_msgs/Twist twist\nfloat64[36] covariance\n"},
      {"geometry_msgs/Transform", "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"},
      {"geometry_msgs/TransformStamped",
       "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n"},
      {"tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms\n"},
      {"nav_msgs/Odometry",
       "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n"
       "geometry_msgs/TwistWithCovariance twist\n"},
      {"nav_msgs/MapMetaData",
       "builtin_interfaces/Time map_load_time\nfloat32 resolution\nuint32 width\nuint32 height\n"
       "geometry_msgs/Pose origin\n"},
      {"nav_msgs/OccupancyGrid", "std_msgs/Header header\nnav_msgs/MapMetaData info\nint8[] data\n"},
      {"nav_msgs/Path", "std_msgs/Header header\ngeometry_msgs/PoseStamped[] poses\n"},
      {"sensor_msgs/LaserScan",
       "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\nfloat32 time_increment\n"
       "float32 scan_time\nfloat32 range_min\nfloat32 range_max\nfloat32[] ranges\nfloat32[] intensities\n"},
      {"sensor_msgs/Image",
       "std_msgs/Header header\nuint32 height\nuint32 width\nstring encoding\nuint8 is_bigendian\nuint32 step\n"
       "uint8[] data\n"},
      {"sensor_msgs/CompressedImage", "std_msgs/Header header\nstring format\nuint8[] data\n"},
      {"sensor_msgs/RegionOfInterest",
       "uint32 x_offset\nuint32 y_offset\nuint32 height\nuint32 width\nbool do_rectify\n"},
      {"sensor_msgs/CameraInfo",
       "std_msgs/Header header\nuint32 height\nuint32 width\nstring distortion_model\nfloat64[] d\nfloat64[9] k\n"
       "float64[9] r\nfloat64[12] p\nuint32 binning_x\nuint32 binning_y\nsensor_msgs/RegionOfInterest roi\n"},
      {"sensor_msgs/PointField",
       "uint8 INT8=1\nuint8 UINT8=2\nuint8 INT16=3\nuint8 UINT16=4\nuint8 INT32=5\nuint8 UINT32=6\nuint8 FLOAT32=7\n"
       "uint8 FLOAT64=8\nstring name\nuint32 offset\nuint8 datatype\nuint32 count\n"},
      {"sensor_msgs/PointCloud2",
       "std_msgs/Header header\nuint32 height\nuint32 width\nsensor_msgs/PointField[] fields\nbool is_bigendian\n"
       "uint32 point_step\nuint32 row_step\nuint8[] data\nbool is_dense\n"},
      {"visualization_msgs/UVCoordinate", "float32 u\nfloat32 v\n"},
      {"visualization_msgs/MeshFile", "string filename\nuint8[] data\n"},
      {"visualization_msgs/Marker",
       "int32 ARROW=0\nint32 CUBE=1\nint32 SPHERE=2\nint32 CYLINDER=3\nint32 TEXT_VIEW_FACING=9\nint32 ADD=0\n"
       "int32 DELETE=2\nint32 DELETEALL=3\nstd_msgs/Header header\nstring ns\nint32 id\nint32 type\nint32 action\n"
       "geometry_msgs/Pose pose\ngeometry_msgs/Vector3 scale\nstd_msgs/ColorRGBA color\n"
       "builtin_interfaces/Duration lifetime\nbool frame_locked\ngeometry_msgs/Point[] points\n"
       "std_msgs/ColorRGBA[] colors\nstring texture_resource\nsensor_msgs/CompressedImage texture\n"
       "visualization_msgs/UVCoordinate[] uv_coordinates\nstring text\nstring mesh_resource\n"
       "visualization_msgs/MeshFile mesh_file\nbool mesh_use_embedded_materials\n"},
      {"visualization_msgs/MarkerArray", "visualization_msgs/Marker[] markers\n"},
      {"rcl_interfaces/Log",
       "byte DEBUG=10\nbyte INFO=20\nbyte WARN=30\nbyte ERROR=40\nbyte FATAL=50\nbuiltin_interfaces/Time stamp\n"
       "uint8 level\nstring name\nstring msg\nstring file\nstring function\nuint32 line\n"},
      {"amiss_msgs/Setup", "uint64 seed\nstring method\nfloat64[16] base_from_laser\n"},
      {"amiss_msgs/Observation",
       "builtin_interfaces/Time stamp\nbuiltin_interfaces/Time odometry_stamp\nfloat64[3] odom_from_base\nfloat64 pan\n"
       "float64 tilt\nbool bumper\nbool has_scan\nbuiltin_interfaces/Time scan_stamp\nfloat64 scan_angle_min\n"
       "float64 scan_angle_step\nfloat64 scan_min_range\nfloat64 scan_max_range\nbool has_frame\n"
       "builtin_interfaces/Time frame_stamp\nfloat64[16] base_from_camera\nfloat64[3] frame_odom_from_base\n"},
      {"amiss_msgs/Decision", "uint8 COMPARED=0\nuint8 SEGMENTING=1\nuint8 EXAMINED=2\nuint8 kind\nint32 region\n"},
  };
  return all;
}

const std::string& definition_of(const std::string& name) {
  const auto found = definitions().find(name);
  if (found == definitions().end()) throw std::logic_error("no definition of message " + name);
  return found->second;
}

/// Types of other messages that the fields have, in the order of the fields.
std::vector<std::string> used_by(const std::string& definition) {
  std::vector<std::string> types;
  std::istringstream lines(definition);
  for (std::string line; std::getline(lines, line);) {
    const std::string type = line.substr(0, line.find_first_of(" ["));
    if (type.find('/') != std::string::npos) types.push_back(type);
  }
  return types;
}

}  // namespace

std::string ros_schema(const std::string& type) {
  std::string name = type;
  if (const auto msg = name.find("/msg/"); msg != std::string::npos) name.erase(msg, 4);
  std::string text = definition_of(name);
  std::vector<std::string> open = used_by(text), told;
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (std::find(told.begin(), told.end(), open[i]) != told.end()) continue;
    told.push_back(open[i]);
    const std::string& definition = definition_of(open[i]);
    text += std::string(80, '=') + "\nMSG: " + open[i] + "\n" + definition;
    const std::vector<std::string> more = used_by(definition);
    open.insert(open.end(), more.begin(), more.end());
  }
  return text;
}

}  // namespace amiss::recording
