#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/files.hpp"
#include "core/result.hpp"
#include "world/internal/image.hpp"
#include "world/mesh_file.hpp"

namespace amiss::world {
namespace {

constexpr std::size_t kMaxImageBytes = std::size_t{256} << 20;

/// A PNG without its ancillary chunks, which change no pixel here but make libpng print complaints about profiles.
std::string without_ancillary_chunks(const std::string& bytes) {
  constexpr std::size_t kSignature = 8, kFrame = 12;  // length, type and checksum around the data of a chunk
  if (bytes.compare(1, 3, "PNG") != 0 || bytes.size() < kSignature) return bytes;
  std::string kept = bytes.substr(0, kSignature);
  for (std::size_t at = kSignature; at + kFrame <= bytes.size();) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8U | static_cast<unsigned char>(bytes[at + i]);
    const bool critical = bytes[at + 4] >= 'A' && bytes[at + 4] <= 'Z';
    if (length > bytes.size() - at - kFrame) return bytes;  // cut short: let the decoder say so
    if (critical) kept.append(bytes, at, length + kFrame);
    at += length + kFrame;
  }
  return kept;
}

cv::Mat decode(const std::string& file_bytes) {
  const std::string bytes = file_bytes.size() > 8 ? without_ancillary_chunks(file_bytes) : std::string();
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  const cv::_InputArray view(bytes.data(), static_cast<int>(bytes.size()));
  try {
    return bytes.empty() ? cv::Mat() : cv::imdecode(view, cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
    return {};  // the caller names the file
  }
}

cv::Mat scaled_down(const cv::Mat& image, int max_edge_px) {
  const int edge = std::max(image.cols, image.rows);
  if (edge <= max_edge_px) return image;
  const double factor = static_cast<double>(max_edge_px) / edge;
  const cv::Size size(std::max(1, static_cast<int>(image.cols * factor)),
                      std::max(1, static_cast<int>(image.rows * factor)));
  cv::Mat small;
  cv::resize(image, small, size, 0.0, 0.0, cv::INTER_AREA);
  return small;
}

}  // namespace

std::shared_ptr<const Texture> decode_texture(const std::string& bytes, int max_texture_px) {
  const cv::Mat decoded = decode(bytes);
  if (decoded.empty()) return nullptr;
  const cv::Mat image = scaled_down(decoded, max_texture_px);
  auto texture = std::make_shared<Texture>();
  texture->width = image.cols;
  texture->height = image.rows;
  texture->pixels.reserve(image.total());
  for (int y = 0; y < image.rows; ++y) {
    const cv::Vec3b* row = image.ptr<cv::Vec3b>(y);
    for (int x = 0; x < image.cols; ++x) texture->pixels.push_back(Rgb{row[x][2], row[x][1], row[x][0]});
  }
  return texture;
}

std::shared_ptr<const Texture> load_texture(const std::filesystem::path& file, int max_texture_px) {
  std::shared_ptr<const Texture> texture = decode_texture(load_bytes(file, kMaxImageBytes), max_texture_px);
  if (texture == nullptr)
    throw InputError(file.string() + ": not a picture that can be read (allowed: PNG, JPEG, BMP, TIFF)");
  return texture;
}

}  // namespace amiss::world
