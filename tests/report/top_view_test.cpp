#include "report/top_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgcodecs.hpp>

namespace amiss::report {
namespace {

cv::Mat decoded(const std::string& png) {
  return cv::imdecode(std::vector<unsigned char>(png.begin(), png.end()), cv::IMREAD_COLOR);
}

int pixels_of(const cv::Mat& image, Rgb colour) {
  int n = 0;
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) n += image.at<cv::Vec3b>(v, u) == cv::Vec3b(colour.b, colour.g, colour.r);
  }
  return n;
}

constexpr Rgb kPink{255, 0, 160};

/// A floor of 1 m x 2 m, 1 cm apart, with a ceiling.
Cloud<Map> floor_and_ceiling() {
  Cloud<Map> cloud;
  for (const float z : {0.0F, 2.5F}) {
    for (int x = 0; x < 100; ++x) {
      for (int y = 0; y < 200; ++y) {
        cloud.points.emplace_back(0.01F * static_cast<float>(x), 0.01F * static_cast<float>(y), z);
        cloud.colours.push_back(z > 1.0F ? Rgb{255, 0, 0} : Rgb{0, 255, 0});
      }
    }
  }
  return cloud;
}

TEST(TopView, ShowsTheRoomBelowItsCeilingAndWhatIsMarkedAbove) {
  Cloud<Map> cloud = floor_and_ceiling();
  cloud.points.emplace_back(0.5F, 0.5F, 0.3F);
  cloud.colours.push_back({0, 0, 0});
  cloud.points.emplace_back(std::nanf(""), 0.0F, 0.0F);
  cloud.colours.push_back({0, 0, 0});
  const auto last = static_cast<std::uint32_t>(cloud.points.size());
  const cv::Mat image = decoded(top_view_png(cloud, {{{last - 2, last - 1}, kPink, ""}}));
  EXPECT_GT(image.rows, 400);  // 2 m of at least 5 mm a pixel
  EXPECT_NEAR(static_cast<double>(image.rows) / image.cols, 2.2 / 1.2, 0.05);
  EXPECT_EQ(pixels_of(image, kPink), 9);
  const cv::Vec3b floor = image.at<cv::Vec3b>(image.rows / 4, image.cols / 2);
  EXPECT_GT(floor[1], floor[2]) << "the green floor, not the red ceiling";
  const cv::Vec3b low_y = image.at<cv::Vec3b>(image.rows - 1 - 120, 120);
  EXPECT_EQ(low_y, cv::Vec3b(160, 0, 255)) << "y is up";
}

TEST(TopView, LargeRoomsStayPicturesAndNothingIsAPicture) {
  Cloud<Map> cloud;
  cloud.points = {{0, 0, 0}, {100, 20, 0}};
  const cv::Mat image = decoded(top_view_png(cloud, {{{0, 1}, kPink, "1"}}));
  EXPECT_LE(image.cols, kTopViewPixels);
  EXPECT_GT(pixels_of(image, kPink), 5);
  EXPECT_FALSE(decoded(top_view_png({}, {{{}, kPink, "none"}})).empty());
}

}  // namespace
}  // namespace amiss::report
