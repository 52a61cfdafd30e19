#include <opencv2/imgproc.hpp>

#include "video/internal/canvas.hpp"
#include "video/internal/panels.hpp"

namespace amiss::video::internal {

namespace {

constexpr int kMargin_px = 10;

/// Map coordinates -> pixels: as large as fits, in the middle.
class Fit {
 public:
  Fit(const FloorGrid& floor, const cv::Size& size) {
    Eigen::AlignedBox2d known;
    for (int y = 0; y < floor.height(); ++y) {
      for (int x = 0; x < floor.width(); ++x) {
        if (floor.at(Cell{x, y}) != Occupancy::kUnknown) known.extend(floor.centre_of({x, y}));
      }
    }
    if (known.isEmpty()) known.extend(Eigen::Vector2d::Zero());
    const Eigen::Vector2d extent = known.sizes().array() + floor.resolution_m();
    scale = std::min((size.width - 2 * kMargin_px) / extent.x(), (size.height - 2 * kMargin_px) / extent.y());
    centre_ = known.center();
    middle_ = {0.5 * size.width, 0.5 * size.height};
  }
  [[nodiscard]] cv::Point at(const Eigen::Vector2d& p) const { return fine(u(p), v(p)); }
  [[nodiscard]] cv::Point pixel(const Eigen::Vector2d& p) const {
    return {static_cast<int>(std::floor(u(p))), static_cast<int>(std::floor(v(p)))};
  }
  [[nodiscard]] Eigen::Vector2d place(int column, int row) const {
    return centre_ + Eigen::Vector2d(column + 0.5 - middle_.x(), middle_.y() - row - 0.5) / scale;
  }
  double scale = 1.0;  // pixels a metre

 private:
  [[nodiscard]] double u(const Eigen::Vector2d& p) const { return middle_.x() + (p.x() - centre_.x()) * scale; }
  [[nodiscard]] double v(const Eigen::Vector2d& p) const { return middle_.y() - (p.y() - centre_.y()) * scale; }
  Eigen::Vector2d centre_, middle_;
};

void draw_floor(cv::Mat& image, const FloorGrid& floor, const Fit& fit) {
  const cv::Vec3b wall(190, 182, 174), free(74, 62, 55);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const Occupancy value = floor.at(fit.place(u, v));
      if (value != Occupancy::kUnknown) image.at<cv::Vec3b>(v, u) = value == Occupancy::kOccupied ? wall : free;
    }
  }
}

void draw_line(cv::Mat& image, const std::vector<Eigen::Vector2d>& points, const Fit& fit, const cv::Scalar& colour,
               int width) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    cv::line(image, fit.at(points[i - 1]), fit.at(points[i]), colour, width, cv::LINE_AA, kShift);
  }
}

void draw_robot(cv::Mat& image, const Pose2<Map, Base>& pose, const Fit& fit) {
  constexpr double kRadius_m = 0.25;
  const int radius = static_cast<int>(kRadius_m * fit.scale * (1 << kShift));
  cv::circle(image, fit.at(pose.position()), radius, kText, cv::FILLED, cv::LINE_AA, kShift);
  const Eigen::Vector2d ahead(std::cos(pose.yaw_rad), std::sin(pose.yaw_rad));
  cv::line(image, fit.at(pose.position()), fit.at(pose.position() + 1.6 * kRadius_m * ahead), kRed, 2, cv::LINE_AA,
           kShift);
}

}  // namespace

void draw_map(cv::Mat image, const page::Story& story, double t_s) {
  const Fit fit(story.floor, image.size());
  draw_floor(image, story.floor, fit);
  std::vector<Eigen::Vector2d> driven;
  for (const auto& [t, pose] : story.poses) {
    if (t <= t_s) driven.push_back(pose.believed.position());
  }
  draw_line(image, driven, fit, kSky, 1);
  if (const auto* path = page::latest(story.paths, t_s)) draw_line(image, *path, fit, kYellow, 1);
  if (const auto* regions = page::latest(story.regions, t_s)) {
    for (const page::StoryRegion& r : *regions) {
      const int radius = static_cast<int>(std::max(4.0, r.radius_m * fit.scale) * (1 << kShift));
      const cv::Scalar& colour = r.withdrawn ? kFaint : (r.examined ? kPurple : kOrange);
      cv::circle(image, fit.at(r.centre_m), radius, colour, 2, cv::LINE_AA, kShift);
    }
  }
  if (const auto* objects = page::latest(story.objects, t_s)) {
    for (const page::StoryObject& o : *objects) {
      const cv::Point at = fit.pixel(o.place.p.head<2>());
      if (o.found) {
        cv::drawMarker(image, at, kGreen, cv::MARKER_SQUARE, 7, 4, cv::LINE_AA);
      } else {
        cv::drawMarker(image, at, kFaint, cv::MARKER_TILTED_CROSS, 7, 1, cv::LINE_AA);
      }
    }
  }
  draw_robot(image, page::pose_at(story, t_s).believed, fit);
}

}  // namespace amiss::video::internal
