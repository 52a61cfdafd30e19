// Colour and depth images from files. InputError where one cannot be read or is of another kind.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/sensors.hpp"

namespace amiss::dataset {

struct ColourImage {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;
};
struct DepthImage {
  int width = 0, height = 0;
  std::vector<float> depth_m;  // NaN where the image says 0
};

/// PNG, JPEG, PPM: three channels of 8 bits (grey ones are spread).
[[nodiscard]] ColourImage load_colour(const std::filesystem::path& file);
/// PNG or PGM, one channel of 16 bits; `scale` units are a metre.
[[nodiscard]] DepthImage load_depth(const std::filesystem::path& file, double scale);
/// The same from the bytes of such a file.
[[nodiscard]] ColourImage decode_colour(const std::string& bytes, const std::string& name);
[[nodiscard]] DepthImage decode_depth(const std::string& bytes, double scale, const std::string& name);

[[nodiscard]] std::string png_bytes(const std::vector<Rgb>& pixels, int width, int height);
/// Depths that the 16 bits cannot hold, and NaN, become 0.
[[nodiscard]] std::string depth_png_bytes(const std::vector<float>& depth_m, int width, int height, double scale);

/// One frame of both; InputError where their sizes or the camera's differ.
[[nodiscard]] RgbdFrame frame_of(ColourImage colour, DepthImage depth, const CameraIntrinsics& camera, Stamp stamp,
                                 const std::string& name);

}  // namespace amiss::dataset
