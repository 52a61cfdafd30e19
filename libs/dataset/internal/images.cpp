#include "dataset/internal/images.hpp"

#include <zlib.h>

#include <cmath>
#include <limits>
#include <opencv2/imgcodecs.hpp>

#include "core/files.hpp"
#include "core/result.hpp"

namespace amiss::dataset {
namespace {

constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kMostImageBytes = std::size_t{1} << 27U;

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = (value << 8U) | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// All chunks are there and undamaged: libpng prints of one that is not, in words of its own.
bool is_whole_png(std::string_view bytes) {
  constexpr std::size_t kAround = 12;  // length and type in front of a chunk's data, CRC behind
  for (std::size_t at = kPng.size(); bytes.size() - at >= kAround;) {
    const std::size_t length = big_endian(bytes, at);
    if (bytes.size() - at - kAround < length) return false;
    const std::string_view checked = bytes.substr(at + 4, 4 + length);
    const auto* data = reinterpret_cast<const Bytef*>(checked.data());
    if (crc32(0, data, static_cast<uInt>(checked.size())) != big_endian(bytes, at + 8 + length)) return false;
    if (checked.starts_with("IEND")) return true;
    at += kAround + length;
  }
  return false;
}

cv::Mat decoded(const std::string& bytes, int flags, const std::string& name) {
  const char* what = ": is no image that can be read (PNG, JPEG, PPM or PGM)";
  if (bytes.empty() || (bytes.starts_with(kPng) && !is_whole_png(bytes))) throw InputError(name + what);
  // OpenCV wants a matrix that may be written to, and only reads it.
  std::vector<uchar> copy(bytes.begin(), bytes.end());
  cv::Mat image;
  try {
    image = cv::imdecode(copy, flags);
  } catch (const cv::Exception&) {
    throw InputError(name + what);
  }
  if (image.empty()) throw InputError(name + what);
  return image;
}

std::string encoded(const cv::Mat& image) {
  std::vector<uchar> bytes;
  if (!cv::imencode(".png", image, bytes, {cv::IMWRITE_PNG_COMPRESSION, 3})) {
    throw std::runtime_error("a PNG image could not be written");
  }
  return {bytes.begin(), bytes.end()};
}

}  // namespace

ColourImage decode_colour(const std::string& bytes, const std::string& name) {
  const cv::Mat image = decoded(bytes, cv::IMREAD_COLOR, name);
  ColourImage colour{image.cols, image.rows, {}};
  colour.pixels.reserve(image.total());
  for (int row = 0; row < image.rows; ++row) {
    const auto* bgr = image.ptr<cv::Vec3b>(row);
    for (int column = 0; column < image.cols; ++column) {
      colour.pixels.push_back({bgr[column][2], bgr[column][1], bgr[column][0]});
    }
  }
  return colour;
}

DepthImage decode_depth(const std::string& bytes, double scale, const std::string& name) {
  const cv::Mat image = decoded(bytes, cv::IMREAD_UNCHANGED, name);
  if (image.type() != CV_16UC1) throw InputError(name + ": a depth image must have one channel of 16 bits");
  DepthImage depth{image.cols, image.rows, {}};
  depth.depth_m.reserve(image.total());
  for (int row = 0; row < image.rows; ++row) {
    const auto* values = image.ptr<std::uint16_t>(row);
    for (int column = 0; column < image.cols; ++column) {
      const bool there = values[column] != 0;
      depth.depth_m.push_back(there ? static_cast<float>(values[column] / scale)
                                    : std::numeric_limits<float>::quiet_NaN());
    }
  }
  return depth;
}

ColourImage load_colour(const std::filesystem::path& file) {
  return decode_colour(load_bytes(file, kMostImageBytes), file.string());
}

DepthImage load_depth(const std::filesystem::path& file, double scale) {
  return decode_depth(load_bytes(file, kMostImageBytes), scale, file.string());
}

std::string png_bytes(const std::vector<Rgb>& pixels, int width, int height) {
  cv::Mat image(height, width, CV_8UC3);
  for (int row = 0; row < height; ++row) {
    auto* bgr = image.ptr<cv::Vec3b>(row);
    for (int column = 0; column < width; ++column) {
      const Rgb c =
          pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
      bgr[column] = {c.b, c.g, c.r};
    }
  }
  return encoded(image);
}

std::string depth_png_bytes(const std::vector<float>& depth_m, int width, int height, double scale) {
  cv::Mat image(height, width, CV_16UC1);
  for (int row = 0; row < height; ++row) {
    auto* values = image.ptr<std::uint16_t>(row);
    for (int column = 0; column < width; ++column) {
      const double units = std::round(
          scale * static_cast<double>(depth_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                              static_cast<std::size_t>(column)]));
      values[column] = units >= 1.0 && units <= 65535.0 ? static_cast<std::uint16_t>(units) : std::uint16_t{0};
    }
  }
  return encoded(image);
}

RgbdFrame frame_of(ColourImage colour, DepthImage depth, const CameraIntrinsics& camera, Stamp stamp,
                   const std::string& name) {
  if (colour.width != depth.width || colour.height != depth.height) {
    throw InputError(name + ": colour is " + std::to_string(colour.width) + " x " + std::to_string(colour.height) +
                     ", depth " + std::to_string(depth.width) + " x " + std::to_string(depth.height) +
                     "; both must be registered to one camera");
  }
  if (depth.width != camera.width || depth.height != camera.height) {
    throw InputError(name + ": is " + std::to_string(depth.width) + " x " + std::to_string(depth.height) +
                     ", the camera " + std::to_string(camera.width) + " x " + std::to_string(camera.height));
  }
  return {stamp, camera, std::move(colour.pixels), std::move(depth.depth_m)};
}

}  // namespace amiss::dataset
