#include "video/internal/canvas.hpp"

#include <opencv2/imgproc.hpp>

namespace amiss::video::internal {

namespace {

constexpr int kFont = cv::FONT_HERSHEY_DUPLEX;
constexpr double kCapital_px = 21.0;  // height of a capital letter at scale 1
constexpr int kFiner = 4;             // letters are drawn so much larger first

std::string printable(std::string text) {
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return text;
}

}  // namespace

int text_width(const std::string& text, double height_px) {
  return cv::getTextSize(printable(text), kFont, height_px / kCapital_px, 1, nullptr).width;
}

namespace {

/// As much of a word or line as fits, with dots where something is left out.
std::string cut(std::string text, double height_px, int width) {
  if (text_width(text, height_px) <= width) return text;
  while (!text.empty() && text_width(text + "...", height_px) > width) text.pop_back();
  return text + "...";
}

}  // namespace

std::vector<std::string> wrapped(const std::string& text, double height_px, int width, std::size_t most) {
  std::vector<std::string> lines(1);
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || text_width(longer, height_px) <= width) {
      lines.back() = longer;
    } else if (lines.size() < most) {
      lines.push_back(word);
    } else {
      lines.back() += " " + text.substr(begin);
      break;
    }
    begin = end + 1;
  }
  for (std::string& line : lines) line = cut(line, height_px, width);
  return lines;
}

void put_text(cv::Mat& image, const std::string& text, cv::Point at, double height_px, const cv::Scalar& colour) {
  const double scale = kFiner * height_px / kCapital_px;
  const int stroke = std::max(1, static_cast<int>(kFiner * height_px / 9.0));
  int base = 0;
  const cv::Size size = cv::getTextSize(printable(text), kFont, scale, stroke, &base);
  const cv::Size small(size.width / kFiner + 2, (size.height + base) / kFiner + 3);
  cv::Mat large(small * kFiner, CV_8UC1, cv::Scalar(0)), mask;
  const int top = size.height / kFiner + 1;
  cv::putText(large, printable(text), {0, top * kFiner}, kFont, scale, cv::Scalar(255), stroke, cv::LINE_AA);
  cv::resize(large, mask, small, 0, 0, cv::INTER_AREA);
  const cv::Rect place = cv::Rect({at.x, at.y - top}, small) & cv::Rect({0, 0}, image.size());
  for (int v = 0; v < place.height; ++v) {
    for (int u = 0; u < place.width; ++u) {
      const int part = mask.at<unsigned char>(v + place.y - at.y + top, u + place.x - at.x);
      auto& pixel = image.at<cv::Vec3b>(place.y + v, place.x + u);
      for (int c = 0; c < 3; ++c) {
        pixel[c] = static_cast<unsigned char>((pixel[c] * (255 - part) + static_cast<int>(colour[c]) * part) / 255);
      }
    }
  }
}

void shade(cv::Mat& image, const cv::Rect& box, const cv::Scalar& colour, double part) {
  cv::Mat below = image(box & cv::Rect({0, 0}, image.size()));
  const cv::Mat above(below.size(), CV_8UC3, colour);
  cv::addWeighted(above, part, below, 1.0 - part, 0.0, below);
}

}  // namespace amiss::video::internal
