#include "dataset/robot_bag.hpp"

#include <algorithm>
#include <map>

#include "core/result.hpp"
#include "dataset/internal/bag_topics.hpp"
#include "dataset/internal/folder_index.hpp"

namespace amiss::dataset {
namespace {

constexpr double kMillimetres = 1000.0;
constexpr double kMaxGapS = 0.5;  // between two messages of odometry

/// Messages of one bag, mostly from the front to the back: the last chunk is kept.
class MessageReader {
 public:
  explicit MessageReader(const BagFile& bag) : bag_(bag) {}
  std::string operator()(const BagPlace& place) {
    if (!place.in_chunk) return bag_.read(place);
    if (!at_ || *at_ != place.chunk) chunk_ = bag_.chunk(place.chunk);
    at_ = place.chunk;
    return chunk_.substr(place.at, place.size);
  }

 private:
  const BagFile& bag_;
  std::optional<std::uint64_t> at_;
  std::string chunk_;
};

const PlacedTopic& topic_of(const std::map<std::string, PlacedTopic>& topics, const std::string& wanted,
                            const char* type, const std::string& name) {
  const auto found = topics.find(wanted);
  if (found != topics.end()) return found->second;
  std::string there;
  for (const auto& [topic, of_it] : topics) there += (there.empty() ? "are: " : ", ") + topic;
  throw InputError(name + ": has no topic '" + wanted + "' of " + type + "; there " +
                   (there.empty() ? "is none of that type" : there));
}

using Poses = std::map<Stamp, Pose2<Odom, Base>>;

std::optional<Pose2<Odom, Base>> pose_at(const Poses& poses, Stamp stamp) {
  const auto after = poses.lower_bound(stamp);
  if (after == poses.end()) return std::nullopt;
  if (after->first == stamp) return after->second;
  if (after == poses.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const double gap_s = seconds(after->first - before->first);
  if (gap_s > kMaxGapS) return std::nullopt;
  const auto &a = before->second, &b = after->second;
  const double part = seconds(stamp - before->first) / gap_s;
  return Pose2<Odom, Base>{a.x_m + part * (b.x_m - a.x_m), a.y_m + part * (b.y_m - a.y_m),
                           wrap_angle(a.yaw_rad + part * wrap_angle(b.yaw_rad - a.yaw_rad))};
}

}  // namespace

class RobotBag::State {
 public:
  State(const std::filesystem::path& file, const RobotBagOptions& options)
      : bag_(file), name_(file.string()), options_(options), topics_(topics_of(bag_, name_)), read_(bag_) {
    read_odometry();
    place_scans();
    place_frames();
    if (!moments_.empty()) begin_ = moments_.begin()->first;
    next_ = moments_.begin();
  }

  std::optional<RobotMoment> next() {
    if (next_ == moments_.end()) return std::nullopt;
    const auto& [stamp, places] = *next_++;
    RobotMoment moment{{shifted(stamp), places.T_odom_base}, {}, {}};
    if (places.scan) {
      moment.scan = parse_ros_scan(read_(*places.scan), name_).scan;
      moment.scan->stamp = moment.odometry.stamp;
    }
    if (places.frame) moment.frame = load(*places.frame);
    return moment;
  }

  Transform<Base, Laser> T_base_laser;
  std::size_t dropped = 0;

 private:
  struct PlacedFrame {
    StampedPlace depth;
    std::optional<BagPlace> colour;
    Transform<Base, Camera> T_base_camera;
    Pose2<Odom, Base> T_odom_base;
  };
  struct Places {
    Pose2<Odom, Base> T_odom_base;
    std::optional<BagPlace> scan;
    std::optional<PlacedFrame> frame;
  };

  [[nodiscard]] Stamp shifted(Stamp stamp) const { return Stamp{stamp - begin_}; }

  void read_odometry() {
    const auto found = topics_.odometries.find(options_.odometry_topic);
    if (options_.is_odometry_needed) {
      topic_of(topics_.odometries, options_.odometry_topic, "nav_msgs/Odometry", name_);
    }
    if (found != topics_.odometries.end()) {
      for (const StampedPlace& one : found->second.places) {
        poses_[one.stamp] = parse_ros_odometry(read_(one.place), name_).odometry.T_odom_base;
      }
    } else {
      for (const auto& [stamp, T] : topics_.frames.motion(options_.odom_frame, options_.base_frame)) {
        poses_[stamp] = on_floor(T);
      }
    }
    if (poses_.empty()) {
      throw InputError(name_ + ": has no topic '" + options_.odometry_topic +
                       "' of nav_msgs/Odometry, and /tf does not move '" + options_.base_frame + "' in '" +
                       options_.odom_frame + "'");
    }
    for (const auto& [stamp, pose] : poses_) moments_[stamp].T_odom_base = pose;
  }

  void place_scans() {
    const PlacedTopic& topic = topic_of(topics_.scans, options_.scan_topic, "sensor_msgs/LaserScan", name_);
    need_place(topic.frame);
    std::optional<Eigen::Isometry3d> T;
    bool is_any_placed = false;
    for (const StampedPlace& scan : topic.places) {
      const auto pose = pose_at(poses_, scan.stamp);
      if (!T) T = topics_.frames.at(options_.base_frame, topic.frame, scan.stamp);
      if (!pose || !T) {
        ++dropped;
        continue;
      }
      Places& moment = moments_[scan.stamp];
      moment.T_odom_base = *pose;
      moment.scan = scan.place;
      is_any_placed = true;
    }
    if (!is_any_placed) throw InputError(name_ + ": no scan lies in the time of its odometry and transforms");
    T_base_laser = {*T};
  }

  /// The packed one where there is no other.
  [[nodiscard]] const PlacedTopic& depth_topic() {
    const auto packed = topics_.packed.find(options_.depth_topic + "/compressedDepth");
    is_depth_packed_ = !topics_.depths.contains(options_.depth_topic) && packed != topics_.packed.end();
    if (is_depth_packed_) return packed->second;
    return topic_of(topics_.depths, options_.depth_topic, "sensor_msgs/Image (16UC1, mono16, 32FC1)", name_);
  }

  void place_frames() {
    const PlacedTopic& depth = depth_topic();
    need_place(depth.frame);
    const auto camera = camera_beside(topics_, options_.depth_topic, name_);
    if (!camera) throw InputError(name_ + ": has no CameraInfo beside '" + options_.depth_topic + "'");
    camera_ = *camera;
    const auto colours = colours_of(depth);
    const Duration period = duration_of(options_.frame_period_s) - std::chrono::milliseconds(1);
    std::optional<Stamp> last;
    for (std::size_t i = 0; i < depth.places.size(); ++i) {
      const StampedPlace& one = depth.places[i];
      if (last && one.stamp - *last < period) continue;
      const auto T_base_camera = topics_.frames.at(options_.base_frame, depth.frame, one.stamp);
      const auto pose = pose_at(poses_, one.stamp);
      const auto moment = moments_.lower_bound(one.stamp);
      if (!T_base_camera || !pose || moment == moments_.end()) {
        ++dropped;
        continue;
      }
      const auto colour = colours.find(i);
      if (moment->second.frame) ++dropped;
      moment->second.frame = PlacedFrame{
          one, colour == colours.end() ? std::nullopt : std::optional(colour->second), {*T_base_camera}, *pose};
      last = one.stamp;
    }
    if (!last) throw InputError(name_ + ": no depth image lies in the time of its odometry and transforms");
  }

  /// By the index of the depth image.
  [[nodiscard]] std::map<std::size_t, BagPlace> colours_of(const PlacedTopic& depth) {
    auto found = topics_.colours.find(options_.colour_topic);
    is_colour_packed_ = found == topics_.colours.end();
    if (is_colour_packed_) found = topics_.packed.find(options_.colour_topic + "/compressed");
    if (is_colour_packed_ && found == topics_.packed.end()) {
      if (options_.is_colour_needed) topic_of(topics_.colours, options_.colour_topic, "sensor_msgs/Image", name_);
      return {};
    }
    const auto stamps_of = [](const PlacedTopic& topic) {
      std::vector<Stamp> stamps;
      for (const StampedPlace& one : topic.places) stamps.push_back(one.stamp);
      return stamps;
    };
    std::map<std::size_t, BagPlace> colours;
    for (const auto& [c, d] : associated(stamps_of(found->second), stamps_of(depth))) {
      colours[d] = found->second.places[c].place;
    }
    return colours;
  }

  void need_place(const std::string& frame) const {
    if (topics_.frames.hangs_below(frame, options_.base_frame)) return;
    throw InputError(name_ + ": /tf and /tf_static do not say where the frame '" + frame + "' is in '" +
                     options_.base_frame + "'");
  }

  RobotMoment::Frame load(const PlacedFrame& placed) {
    const std::string depth_message = read_(placed.depth.place);
    DepthImage depth = is_depth_packed_ ? parse_ros_packed_depth(depth_message, kMillimetres, name_)
                                        : parse_ros_depth(depth_message, kMillimetres, name_);
    ColourImage colour{depth.width, depth.height, {}};
    if (placed.colour) {
      const std::string message = read_(*placed.colour);
      colour = is_colour_packed_ ? parse_ros_packed_colour(message, name_) : parse_ros_colour(message, name_);
    }
    return {frame_of(std::move(colour), std::move(depth), camera_, shifted(placed.depth.stamp), name_),
            placed.T_base_camera, placed.T_odom_base};
  }

  BagFile bag_;
  std::string name_;
  RobotBagOptions options_;
  BagTopics topics_;
  MessageReader read_;
  CameraIntrinsics camera_;
  bool is_depth_packed_ = false, is_colour_packed_ = false;
  Poses poses_;
  std::map<Stamp, Places> moments_;
  std::map<Stamp, Places>::const_iterator next_;
  Stamp begin_;
};

RobotBag::RobotBag(const std::filesystem::path& file, const RobotBagOptions& options)
    : state_(std::make_unique<State>(file, options)) {}

RobotBag::~RobotBag() = default;

const Transform<Base, Laser>& RobotBag::T_base_laser() const { return state_->T_base_laser; }

std::size_t RobotBag::dropped() const { return state_->dropped; }

std::optional<RobotMoment> RobotBag::next() { return state_->next(); }

bool RobotBag::is_bag(const std::filesystem::path& file) { return BagFile::is_bag(file); }

}  // namespace amiss::dataset
