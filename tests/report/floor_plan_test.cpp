#include "report/floor_plan.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

namespace amiss::report {
namespace {

cv::Mat decoded(const std::string& png) {
  return cv::imdecode(std::vector<unsigned char>(png.begin(), png.end()), cv::IMREAD_COLOR);
}

/// A room of 4 m x 3 m with walls, in a larger grid.
FloorGrid room() {
  FloorGrid grid(0.05, {-2.0, -1.0}, 200, 150);
  for (int y = 20; y <= 80; ++y) {
    for (int x = 20; x <= 100; ++x) {
      const bool wall = x == 20 || x == 100 || y == 20 || y == 80;
      grid.set({x, y}, wall ? Occupancy::kOccupied : Occupancy::kFree);
    }
  }
  return grid;
}

int different_pixels(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size()) return -1;
  int different = 0;
  for (int v = 0; v < a.rows; ++v) {
    for (int u = 0; u < a.cols; ++u) different += a.at<cv::Vec3b>(v, u) != b.at<cv::Vec3b>(v, u) ? 1 : 0;
  }
  return different;
}

TEST(FloorPlan, DrawsTheKnownPartAlone) {
  FloorPlan plan;
  plan.grid = room();
  const cv::Mat image = decoded(to_png(plan));
  ASSERT_FALSE(image.empty());
  EXPECT_NEAR(image.cols, 80 * (4.0 + 2 * 0.4), 8);
  EXPECT_NEAR(image.rows, 80 * (3.0 + 2 * 0.4), 8);
  EXPECT_EQ(image.at<cv::Vec3b>(image.rows / 2, image.cols / 2), cv::Vec3b(255, 255, 255)) << "free floor";
  EXPECT_NE(image.at<cv::Vec3b>(2, 2), cv::Vec3b(255, 255, 255)) << "unknown";
}

TEST(FloorPlan, EachKindOfMarkShows) {
  FloorPlan plan;
  plan.grid = room();
  const cv::Mat bare = decoded(to_png(plan));
  const auto marked = [&](auto mark) {
    FloorPlan with = plan;
    mark(with);
    return different_pixels(bare, decoded(to_png(with)));
  };
  const Eigen::Vector2d a(0.0, 1.0), b(2.0, 2.0);
  EXPECT_GT(marked([&](FloorPlan& p) { p.path_m = {a, b}; }), 100);
  EXPECT_GT(marked([&](FloorPlan& p) { p.views = {{{0.0, 1.0, 0.3}, 1.0, 2.0, true}}; }), 100);
  EXPECT_GT(marked([&](FloorPlan& p) { p.regions = {{a, 0.1, false}}; }), 20);
  EXPECT_GT(marked([&](FloorPlan& p) { p.objects = {{a, "mug", true}}; }), 20);
  EXPECT_GT(marked([&](FloorPlan& p) { p.seen = room(); }), 1000);
}

TEST(FloorPlan, UpIsUp) {
  FloorPlan plan;
  plan.grid = room();
  const cv::Mat bare = decoded(to_png(plan));
  plan.regions = {{{1.0, 2.5}, 0.1, false}};  // near the upper wall, y = 3
  const cv::Mat marked = decoded(to_png(plan));
  EXPECT_GT(different_pixels(bare.rowRange(0, bare.rows / 2), marked.rowRange(0, bare.rows / 2)), 20);
  EXPECT_EQ(different_pixels(bare.rowRange(bare.rows / 2, bare.rows), marked.rowRange(bare.rows / 2, bare.rows)), 0);
}

TEST(FloorPlan, NothingKnownIsAPictureToo) { EXPECT_FALSE(decoded(to_png(FloorPlan())).empty()); }

TEST(Picture, KeepsColours) {
  const std::vector<Rgb> pixels{{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  const cv::Mat image = decoded(to_png(pixels, 3, 2));
  ASSERT_EQ(image.size(), cv::Size(3, 2));
  EXPECT_EQ(image.at<cv::Vec3b>(0, 0), cv::Vec3b(0, 0, 255)) << "OpenCV has blue first";
  EXPECT_EQ(image.at<cv::Vec3b>(1, 2), cv::Vec3b(9, 8, 7));
}

}  // namespace
}  // namespace amiss::report
