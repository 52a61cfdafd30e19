#include "page/picture.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/imgcodecs.hpp>

namespace amiss::page {
namespace {

/// Red on the left, blue on the right; near on top, far below, and a hole without depth in the corner.
RgbdFrame frame(int width = 64, int height = 48) {
  RgbdFrame frame;
  frame.stamp = Stamp(duration_of(1.5));
  frame.intrinsics = {width, height, 60.0, 60.0, 32.0, 24.0};
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      frame.colour.push_back(u < width / 2 ? Rgb{220, 10, 10} : Rgb{10, 10, 220});
      const bool hole = u >= width - 16 && v >= height - 16;
      frame.depth_m.push_back(hole ? std::numeric_limits<float>::quiet_NaN() : (v < height / 2 ? 0.5F : 3.9F));
    }
  }
  return frame;
}

cv::Mat decoded(const std::string& jpeg) {
  return cv::imdecode(std::vector<unsigned char>(jpeg.begin(), jpeg.end()), cv::IMREAD_COLOR);
}
int brightness(const cv::Vec3b& bgr) { return bgr[0] + bgr[1] + bgr[2]; }

TEST(Picture, HalfTheSizeKeepsEverySecondPixel) {
  const RgbdFrame whole = frame(), half = half_size(whole);
  EXPECT_EQ(half.stamp, whole.stamp);
  EXPECT_EQ(half.intrinsics.width, 32);
  EXPECT_EQ(half.intrinsics.height, 24);
  EXPECT_DOUBLE_EQ(half.intrinsics.fx, 30.0);
  ASSERT_EQ(half.colour.size(), 32U * 24U);
  for (std::size_t v = 0; v < 24; ++v) {
    for (std::size_t u = 0; u < 32; ++u) EXPECT_EQ(half.colour[v * 32 + u], whole.colour[2 * v * 64 + 2 * u]);
  }
}

TEST(Picture, ColoursAreThoseOfTheFrame) {
  const cv::Mat picture = decoded(colour_jpeg(frame()));
  ASSERT_EQ(picture.size(), cv::Size(64, 48));
  EXPECT_GT(picture.at<cv::Vec3b>(24, 8)[2], 180) << "red";
  EXPECT_GT(picture.at<cv::Vec3b>(24, 56)[0], 180) << "blue";
}

TEST(Picture, NearIsBrightAndUnknownIsBlack) {
  const cv::Mat picture = decoded(depth_jpeg(frame()));
  const int near = brightness(picture.at<cv::Vec3b>(8, 8)), far = brightness(picture.at<cv::Vec3b>(40, 8));
  EXPECT_GT(near, far);
  EXPECT_LT(brightness(picture.at<cv::Vec3b>(43, 59)), far);
}

TEST(Picture, OutlinesTheSegmentsAndNothingElse) {
  const RgbdFrame whole = frame();
  segment::Segment segment;
  for (std::uint32_t v = 10; v < 20; ++v) {
    for (std::uint32_t u = 5; u < 15; ++u) segment.pixels.push_back(v * 64 + u);
  }
  const auto picture = outlined(whole, {segment});
  std::size_t changed = 0;
  for (std::size_t i = 0; i < picture.size(); ++i) changed += picture[i] == whole.colour[i] ? 0U : 1U;
  EXPECT_EQ(changed, 36U) << "the border of 10 x 10 pixels";
  EXPECT_EQ(picture[15 * 64 + 10], whole.colour[15 * 64 + 10]);
  EXPECT_EQ(decoded(segments_jpeg(whole, {segment})).size(), cv::Size(64, 48));
}

}  // namespace
}  // namespace amiss::page
