// Drawing on a picture: text with soft edges, filled and translucent boxes; colours of the film (Okabe and Ito's, which
// colour-blind people tell apart).
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace amiss::video::internal {

// Blue, green, red, as OpenCV has them.
inline const cv::Scalar kBackground(28, 22, 19), kPanel(44, 36, 32), kText(240, 236, 232), kFaint(160, 150, 142),
    kOrange(0, 159, 230), kSky(233, 180, 86), kGreen(115, 158, 0), kPurple(167, 121, 204), kRed(0, 94, 213),
    kYellow(66, 228, 240);
inline constexpr int kShift = 4;  // fixed point of OpenCV's drawing, for soft edges

[[nodiscard]] inline cv::Point fine(double x, double y) {
  return {static_cast<int>(x * (1 << kShift)), static_cast<int>(y * (1 << kShift))};
}

/// The width of a text [px].
[[nodiscard]] int text_width(const std::string& text, double height_px);
/// The text in lines of at most `width` pixels, broken between words; what does not fit into `most` lines is cut, with
/// dots. At least one line.
[[nodiscard]] std::vector<std::string> wrapped(const std::string& text, double height_px, int width, std::size_t most);
/// `at`: left end of the base line.
void put_text(cv::Mat& image, const std::string& text, cv::Point at, double height_px, const cv::Scalar& colour);
/// A box of which `part` (0 .. 1) covers what is below.
void shade(cv::Mat& image, const cv::Rect& box, const cv::Scalar& colour, double part);

}  // namespace amiss::video::internal
