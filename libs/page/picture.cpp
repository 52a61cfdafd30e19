#include "page/picture.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace amiss::page {

namespace {

constexpr int kQuality = 65;

std::string jpeg_bytes(const cv::Mat& bgr) {
  std::vector<unsigned char> bytes;
  cv::imencode(".jpg", bgr, bytes, {cv::IMWRITE_JPEG_QUALITY, kQuality});
  return {bytes.begin(), bytes.end()};
}

std::string jpeg_bytes(const std::vector<Rgb>& pixels, int width, int height) {
  cv::Mat bgr(height, width, CV_8UC3);
  std::transform(pixels.begin(), pixels.end(), bgr.begin<cv::Vec3b>(),
                 [](const Rgb& p) { return cv::Vec3b(p.b, p.g, p.r); });
  return jpeg_bytes(bgr);
}

}  // namespace

RgbdFrame half_size(const RgbdFrame& frame) {
  RgbdFrame small{frame.stamp, frame.intrinsics, {}, {}};
  CameraIntrinsics& camera = small.intrinsics;
  camera.width /= 2;
  camera.height /= 2;
  for (double* value : {&camera.fx, &camera.fy, &camera.cx, &camera.cy}) *value /= 2.0;
  const auto pixels = static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
  small.colour.reserve(pixels);
  small.depth_m.reserve(pixels);
  for (int v = 0; v < camera.height; ++v) {
    const std::size_t row = static_cast<std::size_t>(2 * v) * static_cast<std::size_t>(frame.intrinsics.width);
    for (int u = 0; u < camera.width; ++u) {
      const std::size_t pixel = row + static_cast<std::size_t>(2 * u);
      small.colour.push_back(frame.colour[pixel]);
      small.depth_m.push_back(frame.depth_m[pixel]);
    }
  }
  return small;
}

std::string colour_jpeg(const RgbdFrame& frame) {
  return jpeg_bytes(frame.colour, frame.intrinsics.width, frame.intrinsics.height);
}

std::string depth_jpeg(const RgbdFrame& frame) {
  cv::Mat near(frame.intrinsics.height, frame.intrinsics.width, CV_8UC1);
  std::transform(frame.depth_m.begin(), frame.depth_m.end(), near.begin<unsigned char>(), [](float depth_m) {
    const float part = std::isfinite(depth_m) ? std::clamp(1.0F - depth_m / kFarthestM, 0.0F, 1.0F) : 0.0F;
    return static_cast<unsigned char>(std::lround(255.0F * part));
  });
  cv::Mat colours;
  cv::applyColorMap(near, colours, cv::COLORMAP_VIRIDIS);
  for (int v = 0; v < near.rows; ++v) {
    for (int u = 0; u < near.cols; ++u) {
      const auto pixel =
          static_cast<std::size_t>(v) * static_cast<std::size_t>(near.cols) + static_cast<std::size_t>(u);
      if (!std::isfinite(frame.depth_m[pixel])) colours.at<cv::Vec3b>(v, u) = {0, 0, 0};
    }
  }
  return jpeg_bytes(colours);
}

std::vector<Rgb> outlined(const RgbdFrame& frame, const std::vector<segment::Segment>& segments) {
  constexpr Rgb kOutline{255, 60, 180};
  const int width = frame.intrinsics.width, height = frame.intrinsics.height;
  std::vector<Rgb> picture = frame.colour;
  for (const segment::Segment& s : segments) {
    std::vector<bool> inside(picture.size(), false);
    for (const std::uint32_t pixel : s.pixels) inside[pixel] = true;
    for (const std::uint32_t pixel : s.pixels) {
      const int u = static_cast<int>(pixel) % width, v = static_cast<int>(pixel) / width;
      const bool border = u == 0 || v == 0 || u == width - 1 || v == height - 1 || !inside[pixel - 1] ||
                          !inside[pixel + 1] || !inside[pixel - static_cast<std::uint32_t>(width)] ||
                          !inside[pixel + static_cast<std::uint32_t>(width)];
      if (border) picture[pixel] = kOutline;
    }
  }
  return picture;
}

std::string segments_jpeg(const RgbdFrame& frame, const std::vector<segment::Segment>& segments) {
  return jpeg_bytes(outlined(frame, segments), frame.intrinsics.width, frame.intrinsics.height);
}

}  // namespace amiss::page
