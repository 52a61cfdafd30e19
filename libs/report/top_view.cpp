#include "report/top_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace amiss::report {

namespace {

constexpr double kFinestPixel_m = 0.005, kBorder_m = 0.1, kHighest_m = 2.0, kFloorShare = 0.01;
constexpr int kBackground = 245, kPaled = 120;  // the room itself is paled, so that marks stand out
const Rgb kGrey{150, 150, 150};

class View {
 public:
  explicit View(const Cloud<Map>& cloud) : cloud_(cloud) {
    std::vector<float> heights;
    Eigen::Array2f low = Eigen::Array2f::Constant(std::numeric_limits<float>::max()), high = -low;
    for (const Eigen::Vector3f& p : cloud.points) {
      if (!p.allFinite()) continue;
      heights.push_back(p.z());
      low = low.min(p.head<2>().array());
      high = high.max(p.head<2>().array());
    }
    if (heights.empty()) low = high = Eigen::Array2f::Zero();
    if (!heights.empty()) {
      const auto floor =
          heights.begin() + static_cast<std::ptrdiff_t>(kFloorShare * static_cast<double>(heights.size()));
      std::nth_element(heights.begin(), floor, heights.end());
      ceiling_m_ = *floor + static_cast<float>(kHighest_m);
    }
    low_ = low.cast<double>() - kBorder_m;
    const Eigen::Array2d size = high.cast<double>() + kBorder_m - low_;
    pixel_m_ = std::max(kFinestPixel_m, size.maxCoeff() / (kTopViewPixels - 1));
    image_ = cv::Mat(static_cast<int>(size.y() / pixel_m_) + 1, static_cast<int>(size.x() / pixel_m_) + 1, CV_8UC3,
                     cv::Scalar::all(kBackground));
  }

  void draw_room() {
    cv::Mat heights(image_.size(), CV_32F, cv::Scalar::all(-std::numeric_limits<float>::max()));
    for (std::size_t i = 0; i < cloud_.points.size(); ++i) {
      const Eigen::Vector3f& p = cloud_.points[i];
      if (!p.allFinite() || p.z() > ceiling_m_) continue;
      const Rgb c = cloud_.colours.empty() ? kGrey : cloud_.colours[i];
      const auto pale = [](int v) { return static_cast<unsigned char>(kPaled + v * (kBackground - kPaled) / 255); };
      for_each_pixel(p, [&](int u, int v) {
        if (p.z() < heights.at<float>(v, u)) return;
        heights.at<float>(v, u) = p.z();
        image_.at<cv::Vec3b>(v, u) = {pale(c.b), pale(c.g), pale(c.r)};
      });
    }
  }

  void draw(const MarkedPoints& mark) {
    for (const std::uint32_t i : mark.points) {
      if (!cloud_.points[i].allFinite()) continue;
      for_each_pixel(cloud_.points[i], [&](int u, int v) {
        image_.at<cv::Vec3b>(v, u) = {mark.colour.b, mark.colour.g, mark.colour.r};
      });
    }
  }

  void write_label(const MarkedPoints& mark) {
    Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::max()), high = -low;
    for (const std::uint32_t i : mark.points) {
      if (!cloud_.points[i].allFinite()) continue;
      low = low.min(cloud_.points[i].head<2>().cast<double>().array());
      high = high.max(cloud_.points[i].head<2>().cast<double>().array());
    }
    if (mark.label.empty() || low.x() > high.x()) return;
    const cv::Point place(u_of(high.x()) + 3, v_of(0.5 * (low.y() + high.y())) + 4);
    cv::putText(image_, mark.label, place, cv::FONT_HERSHEY_SIMPLEX, 0.45, cv::Scalar::all(255), 3, cv::LINE_AA);
    cv::putText(image_, mark.label, place, cv::FONT_HERSHEY_SIMPLEX, 0.45, cv::Scalar::all(20), 1, cv::LINE_AA);
  }

  [[nodiscard]] std::string png() const {
    std::vector<unsigned char> bytes;
    cv::imencode(".png", image_, bytes);
    return {bytes.begin(), bytes.end()};
  }

 private:
  [[nodiscard]] int u_of(double x) const { return static_cast<int>((x - low_.x()) / pixel_m_); }
  [[nodiscard]] int v_of(double y) const { return image_.rows - 1 - static_cast<int>((y - low_.y()) / pixel_m_); }

  /// The pixel of a point and its neighbours: a cloud at 1 cm has no holes then.
  template <class Visit>
  void for_each_pixel(const Eigen::Vector3f& p, Visit visit) const {
    const int u = u_of(static_cast<double>(p.x())), v = v_of(static_cast<double>(p.y()));
    for (int y = std::max(0, v - 1); y <= std::min(image_.rows - 1, v + 1); ++y) {
      for (int x = std::max(0, u - 1); x <= std::min(image_.cols - 1, u + 1); ++x) visit(x, y);
    }
  }

  const Cloud<Map>& cloud_;
  Eigen::Array2d low_ = Eigen::Array2d::Zero();
  float ceiling_m_ = std::numeric_limits<float>::max();
  double pixel_m_ = kFinestPixel_m;
  cv::Mat image_;
};

}  // namespace

std::string top_view_png(const Cloud<Map>& cloud, const std::vector<MarkedPoints>& marks) {
  View view(cloud);
  view.draw_room();
  for (const MarkedPoints& mark : marks) view.draw(mark);
  for (const MarkedPoints& mark : marks) view.write_label(mark);
  return view.png();
}

}  // namespace amiss::report
