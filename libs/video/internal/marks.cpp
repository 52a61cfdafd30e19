#include <numbers>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "video/internal/canvas.hpp"
#include "video/internal/panels.hpp"

namespace amiss::video::internal {

namespace {

constexpr double kStep_m = 0.05, kOverFloor_m = 0.015, kNear_m = 0.2;
constexpr float kTolerance_m = 0.06F;  // by which a mark may lie behind the surface that it is on
constexpr int kCorners = 64;           // of a circle

class Marker {
 public:
  Marker(cv::Mat& image, const Transform<World, Map>& T_world_map, const ThirdPerson& view)
      : image_(image), view_(view), T_camera_map_(view.T_world_camera.inverse() * T_world_map) {}

  /// A line on the floor; pieces that something hides are left out.
  void line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const cv::Scalar& colour, int width) {
    const int pieces = std::max(1, static_cast<int>(std::ceil((b - a).norm() / kStep_m)));
    std::optional<Seen> last = seen({a.x(), a.y(), kOverFloor_m});
    for (int i = 1; i <= pieces; ++i) {
      const Eigen::Vector2d p = a + (b - a) * i / pieces;
      const std::optional<Seen> now = seen({p.x(), p.y(), kOverFloor_m});
      if (last && now && last->free && now->free)
        cv::line(image_, fine(last->u, last->v), fine(now->u, now->v), colour, width, cv::LINE_AA, kShift);
      last = now;
    }
  }
  void circle(const Eigen::Vector2d& centre, double radius_m, const cv::Scalar& colour, int width) {
    const auto on_it = [&](int i) -> Eigen::Vector2d {
      const double angle = 2.0 * std::numbers::pi * i / kCorners;
      return centre + radius_m * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    };
    for (int i = 0; i < kCorners; ++i) line(on_it(i), on_it(i + 1), colour, width);
  }
  void label(const Eigen::Vector3d& p, const std::string& text, const cv::Scalar& colour) {
    constexpr double kHeight_px = 11.0;
    const std::optional<Seen> at = seen(p);
    if (!at) return;
    const cv::Point from(static_cast<int>(at->u) + 14, static_cast<int>(at->v) - 12);
    shade(image_, {from.x - 5, from.y - 15, text_width(text, kHeight_px) + 10, 21}, kBackground, 0.75);
    put_text(image_, text, from, kHeight_px, colour);
  }

 private:
  struct Seen {
    double u = 0.0, v = 0.0;
    bool free = false;  // nothing stands before it
  };
  [[nodiscard]] std::optional<Seen> seen(const Eigen::Vector3d& p_map) const {
    const CameraIntrinsics& c = view_.picture.intrinsics;
    const Eigen::Vector3d p = T_camera_map_.T * p_map;
    if (p.z() < kNear_m) return std::nullopt;
    const Seen s{c.fx * p.x() / p.z() + c.cx, c.fy * p.y() / p.z() + c.cy, false};
    const int u = static_cast<int>(std::lround(s.u)), v = static_cast<int>(std::lround(s.v));
    if (u < 0 || v < 0 || u >= c.width || v >= c.height) return std::nullopt;
    const float depth_m =
        view_.picture
            .depth_m[static_cast<std::size_t>(v) * static_cast<std::size_t>(c.width) + static_cast<std::size_t>(u)];
    return Seen{s.u, s.v, !(static_cast<float>(p.z()) > depth_m + kTolerance_m)};
  }

  cv::Mat& image_;
  const ThirdPerson& view_;
  Transform<Camera, Map> T_camera_map_;
};

}  // namespace

void draw_marks(cv::Mat& image, const page::Story& story, double t_s, const ThirdPerson& view) {
  Marker marker(image, story.place.T_world_map, view);
  Eigen::Vector2d last = story.poses.front().value.truth.position();
  for (const auto& [t, pose] : story.poses) {
    if (t > t_s) break;
    marker.line(last, pose.truth.position(), kSky, 2);
    last = pose.truth.position();
  }
  if (const auto* path = page::latest(story.paths, t_s)) {
    for (std::size_t i = 1; i < path->size(); ++i) marker.line((*path)[i - 1], (*path)[i], kYellow, 1);
  }
  if (const auto* regions = page::latest(story.regions, t_s)) {
    for (const page::StoryRegion& r : *regions) {
      if (!r.withdrawn) marker.circle(r.centre_m, r.radius_m, r.examined ? kPurple : kOrange, 2);
    }
  }
  if (const auto* objects = page::latest(story.objects, t_s)) {
    for (const page::StoryObject& o : *objects) {
      if (o.found) marker.label(o.place.p, o.name, kText);
    }
  }
}

}  // namespace amiss::video::internal
