#include "dataset/trajectory_files.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/result.hpp"
#include "dataset/internal/records.hpp"
#include "dataset/internal/text.hpp"

namespace amiss::dataset {
namespace {

constexpr double kMaxPoseGapS = 0.5;
constexpr double kNotRigid = 1e-3;  // that columns of a rotation may miss length 1 and right angles

/// The lines that say something, with their numbers.
class Lines {
 public:
  Lines(std::string_view bytes, const std::string& name) : reader_(bytes), name_(name) {}

  /// The words of the next line that is neither empty nor a comment; empty at the end.
  std::vector<std::string_view> next() {
    while (const auto line = reader_.next()) {
      const auto words = words_of(*line);
      if (!words.empty() && !words[0].starts_with('#')) return words;
    }
    return {};
  }
  [[nodiscard]] int line() const { return reader_.line(); }

  Eigen::Matrix4d matrix() {
    Eigen::Matrix4d M;
    for (int row = 0; row < 4; ++row) {
      const auto words = next();
      if (words.size() != 4) refuse_line(name_, line(), "a row of a 4 x 4 matrix must have four numbers");
      for (int column = 0; column < 4; ++column) {
        M(row, column) = finite_number(words[static_cast<std::size_t>(column)], name_, line());
      }
    }
    return M;
  }

 private:
  LineReader reader_;
  const std::string& name_;
};

Transform<Map, Camera> rigid(const Eigen::Matrix4d& M, const std::string& name, int line) {
  const Eigen::Matrix3d R = M.topLeftCorner<3, 3>();
  const bool orthogonal = (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < kNotRigid;
  const bool last_row = (M.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() < kNotRigid;
  if (!orthogonal || R.determinant() < 0.0 || !last_row) refuse_line(name, line, "this matrix is no rigid motion");
  Transform<Map, Camera> pose;
  pose.T.linear() = Eigen::Quaterniond(R).normalized().toRotationMatrix();
  pose.T.translation() = M.topRightCorner<3, 1>();
  return pose;
}

void append(double value, std::string& text) {
  std::array<char, 40> digits{};
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text += ' ';
  text.append(digits.data(), written.ptr);
}

}  // namespace

std::vector<StampedPose> parse_tum_trajectory(std::string_view bytes, const std::string& name) {
  std::vector<StampedPose> poses;
  Lines lines(bytes, name);
  for (auto words = lines.next(); !words.empty(); words = lines.next()) {
    if (words.size() != 8) refuse_line(name, lines.line(), "a pose is 't x y z qx qy qz qw', eight numbers");
    StampedPose pose;
    pose.stamp = stamp_of(words[0], name, lines.line());
    std::array<double, 7> n{};
    for (std::size_t i = 0; i < n.size(); ++i) n[i] = finite_number(words[i + 1], name, lines.line());
    const Eigen::Quaterniond q(n[6], n[3], n[4], n[5]);
    if (!(std::abs(q.norm() - 1.0) < 0.1)) refuse_line(name, lines.line(), "the quaternion's length must be 1");
    if (!poses.empty() && pose.stamp <= poses.back().stamp) refuse_line(name, lines.line(), "times must grow");
    pose.T_map_camera.T.linear() = q.normalized().toRotationMatrix();
    pose.T_map_camera.T.translation() = Eigen::Vector3d(n[0], n[1], n[2]);
    poses.push_back(pose);
  }
  return poses;
}

std::string tum_trajectory_bytes(const std::vector<StampedPose>& poses) {
  std::string text = "# timestamp tx ty tz qx qy qz qw\n";
  for (const StampedPose& pose : poses) {
    const Eigen::Vector3d t = pose.T_map_camera.position();
    const Eigen::Quaterniond q(pose.T_map_camera.T.linear());
    text += text_of(pose.stamp);
    for (const double value : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}) append(value, text);
    text += '\n';
  }
  return text;
}

std::vector<Transform<Map, Camera>> parse_open3d_log(std::string_view bytes, const std::string& name) {
  std::vector<Transform<Map, Camera>> poses;
  Lines lines(bytes, name);
  for (auto words = lines.next(); !words.empty(); words = lines.next()) {
    if (words.size() != 3) refuse_line(name, lines.line(), "a pose begins with a line of three numbers");
    const Eigen::Matrix4d M = lines.matrix();
    poses.push_back(rigid(M, name, lines.line()));
  }
  return poses;
}

Transform<Map, Camera> parse_pose_matrix(std::string_view bytes, const std::string& name) {
  Lines lines(bytes, name);
  const Eigen::Matrix4d M = lines.matrix();
  return rigid(M, name, lines.line());
}

Eigen::Isometry3d between(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double part) {
  const Eigen::Quaterniond q_a(a.linear()), q_b(b.linear());
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = q_a.slerp(part, q_b).normalized().toRotationMatrix();
  result.translation() = (1.0 - part) * a.translation() + part * b.translation();
  return result;
}

std::optional<Transform<Map, Camera>> pose_at(const std::vector<StampedPose>& poses, Stamp stamp) {
  const auto after = std::lower_bound(poses.begin(), poses.end(), stamp,
                                      [](const StampedPose& pose, Stamp t) { return pose.stamp < t; });
  if (after == poses.end()) return std::nullopt;
  if (after->stamp == stamp) return after->T_map_camera;
  if (after == poses.begin()) return std::nullopt;
  const StampedPose& a = *(after - 1);
  const StampedPose& b = *after;
  const double gap_s = seconds(b.stamp - a.stamp);
  if (gap_s > kMaxPoseGapS) return std::nullopt;
  return Transform<Map, Camera>{between(a.T_map_camera.T, b.T_map_camera.T, seconds(stamp - a.stamp) / gap_s)};
}

}  // namespace amiss::dataset
