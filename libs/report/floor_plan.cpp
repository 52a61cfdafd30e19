#include "report/floor_plan.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace amiss::report {

namespace {

constexpr double kPixelsPerMetre = 80.0;
constexpr double kBorder = 0.4;  // m round what is known
constexpr int kShift = 4;        // fractional bits of OpenCV's coordinates

const cv::Scalar kUnknown(236, 232, 228), kFree(255, 255, 255), kSeen(240, 248, 236), kWall(60, 56, 52);
const cv::Scalar kPath(200, 120, 30), kView(222, 190, 150), kRegion(0, 150, 230), kWithdrawn(170, 170, 170);
const cv::Scalar kFound(90, 150, 0), kMissed(40, 40, 210), kText(40, 40, 40);

/// Where the map's metres are on the picture; only what is known and a border is drawn.
class Canvas {
 public:
  explicit Canvas(const FloorGrid& grid) {
    Eigen::AlignedBox2d known;
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        if (grid.at(Cell{x, y}) != Occupancy::kUnknown) known.extend(grid.centre_of({x, y}));
      }
    }
    if (known.isEmpty()) known.extend(Eigen::Vector2d(0.0, 0.0));
    low_ = known.min() - Eigen::Vector2d::Constant(kBorder);
    high_ = known.max() + Eigen::Vector2d::Constant(kBorder);
    const Eigen::Vector2d size = (high_ - low_) * kPixelsPerMetre;
    image = cv::Mat(static_cast<int>(size.y()), static_cast<int>(size.x()), CV_8UC3, kUnknown);
  }
  [[nodiscard]] cv::Point at(const Eigen::Vector2d& p) const {
    const double scale = kPixelsPerMetre * (1 << kShift);
    return {static_cast<int>((p.x() - low_.x()) * scale), static_cast<int>((high_.y() - p.y()) * scale)};
  }
  [[nodiscard]] cv::Point pixel(const Eigen::Vector2d& p) const {
    const cv::Point fine = at(p);
    return {fine.x >> kShift, fine.y >> kShift};
  }
  cv::Mat image;

 private:
  Eigen::Vector2d low_, high_;
};

void draw_grid(Canvas& canvas, const FloorPlan& plan) {
  const FloorGrid& grid = plan.grid;
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5 * grid.resolution_m());
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const Occupancy value = grid.at(Cell{x, y});
      if (value == Occupancy::kUnknown) continue;
      const Eigen::Vector2d centre = grid.centre_of({x, y});
      const bool seen = plan.seen.at(centre) != Occupancy::kUnknown;
      const cv::Scalar& colour = value == Occupancy::kOccupied ? kWall : (seen ? kSeen : kFree);
      cv::rectangle(canvas.image, canvas.pixel(centre - half), canvas.pixel(centre + half), colour, cv::FILLED);
    }
  }
}

void draw_views(Canvas& canvas, const FloorPlan& plan) {
  for (const PlannedView& view : plan.views) {
    const auto corner = [&](double angle) {
      const double yaw = view.T_map_base.yaw_rad + angle;
      const double side = view.height_m / std::cos(0.5 * view.angle_rad);
      return canvas.at(view.T_map_base.position() + side * Eigen::Vector2d(std::cos(yaw), std::sin(yaw)));
    };
    const std::vector<cv::Point> triangle{canvas.at(view.T_map_base.position()), corner(-0.5 * view.angle_rad),
                                          corner(0.5 * view.angle_rad)};
    cv::polylines(canvas.image, triangle, true, kView, view.visited ? 2 : 1, cv::LINE_AA, kShift);
  }
}

void draw_path(Canvas& canvas, const FloorPlan& plan) {
  for (std::size_t i = 1; i < plan.path_m.size(); ++i) {
    cv::line(canvas.image, canvas.at(plan.path_m[i - 1]), canvas.at(plan.path_m[i]), kPath, 2, cv::LINE_AA, kShift);
  }
  if (!plan.path_m.empty()) cv::circle(canvas.image, canvas.pixel(plan.path_m.front()), 7, kPath, 2, cv::LINE_AA);
}

void draw_marks(Canvas& canvas, const FloorPlan& plan) {
  for (const PlannedCircle& region : plan.regions) {
    const int radius = std::max(4, static_cast<int>(region.radius_m * kPixelsPerMetre));
    cv::circle(canvas.image, canvas.pixel(region.centre_m), radius, region.withdrawn ? kWithdrawn : kRegion, 2,
               cv::LINE_AA);
  }
  for (const PlannedMark& object : plan.objects) {
    const cv::Point place = canvas.pixel(object.place_m);
    const cv::Scalar& colour = object.found ? kFound : kMissed;
    cv::drawMarker(canvas.image, place, colour, object.found ? cv::MARKER_SQUARE : cv::MARKER_TILTED_CROSS, 11, 3);
    cv::putText(canvas.image, object.label + (object.found ? "" : " (missed)"), place + cv::Point(12, 5),
                cv::FONT_HERSHEY_SIMPLEX, 0.5, kText, 1, cv::LINE_AA);
  }
}

std::string png_bytes(const cv::Mat& image) {
  std::vector<unsigned char> bytes;
  cv::imencode(".png", image, bytes);
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::string to_png(const FloorPlan& plan) {
  Canvas canvas(plan.grid);
  draw_grid(canvas, plan);
  draw_views(canvas, plan);
  draw_path(canvas, plan);
  draw_marks(canvas, plan);
  return png_bytes(canvas.image);
}

std::string to_png(const std::vector<Rgb>& pixels, int width, int height) {
  cv::Mat image(height, width, CV_8UC3);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const Rgb& p =
          pixels[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u)];
      image.at<cv::Vec3b>(v, u) = {p.b, p.g, p.r};
    }
  }
  return png_bytes(image);
}

}  // namespace amiss::report
