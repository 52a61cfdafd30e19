#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "video/internal/canvas.hpp"
#include "video/internal/panels.hpp"

namespace amiss::video::internal {

namespace {

constexpr int kMargin_px = 16, kBarTop_px = 50, kBarHeight_px = 8;

std::string clock_text(double t_s) {
  const int tenths = static_cast<int>(t_s * 10.0 + 1e-6);
  return fmt::format("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

cv::Scalar colour_of(page::Note::Kind kind) {
  switch (kind) {
    case page::Note::Kind::kDetected:
      return kOrange;
    case page::Note::Kind::kExamined:
      return kPurple;
    case page::Note::Kind::kFound:
      return kGreen;
    case page::Note::Kind::kCollision:
      return kRed;
    case page::Note::Kind::kScript:
      return kText;
    case page::Note::Kind::kPlan:
    case page::Note::Kind::kLog:
      break;
  }
  return kFaint;
}

/// In the height of a line: one, or two smaller ones.
void draw_caption(cv::Mat& image, const page::Note& note, const cv::Rect& box) {
  constexpr double kHeight_px = 13.0, kSmall_px = 10.0;
  constexpr int kBaseLine_px = 30, kFirst_px = 20, kSecond_px = 38;
  const bool plain = note.kind == page::Note::Kind::kPlan || note.kind == page::Note::Kind::kLog;
  const cv::Scalar colour = plain ? kText : colour_of(note.kind);
  if (text_width(note.text, kHeight_px) <= box.width)
    return put_text(image, note.text, {box.x, kBaseLine_px}, kHeight_px, colour);
  const std::vector<std::string> lines = wrapped(note.text, kSmall_px, box.width, 2);
  for (std::size_t i = 0; i < lines.size(); ++i)
    put_text(image, lines[i], {box.x, i == 0 ? kFirst_px : kSecond_px}, kSmall_px, colour);
}

}  // namespace

void draw_timeline(cv::Mat image, const page::Story& story, double t_s) {
  const double end_s = std::max(story.end_s, 1e-3);
  const int left = kMargin_px, width = image.cols - 2 * kMargin_px;
  const auto x_of = [&](double t) { return left + static_cast<int>(width * std::clamp(t / end_s, 0.0, 1.0)); };
  put_text(image, clock_text(t_s), {left, 32}, 18.0, kText);
  const std::string length = clock_text(story.end_s);
  const int right = image.cols - kMargin_px - text_width(length, 11.0), caption = left + 150;
  put_text(image, length, {right, 30}, 11.0, kFaint);
  const page::Note* now = page::latest(story.notes, t_s);
  if (now != nullptr) draw_caption(image, *now, {caption, 0, right - kMargin_px - caption, kBarTop_px});
  cv::rectangle(image, {left, kBarTop_px, width, kBarHeight_px}, kFaint * 0.5, cv::FILLED);
  cv::rectangle(image, {left, kBarTop_px, x_of(t_s) - left, kBarHeight_px}, kSky, cv::FILLED);
  for (const auto& [t, note] : story.notes) {
    const bool small = note.kind == page::Note::Kind::kPlan || note.kind == page::Note::Kind::kLog;
    if (small) continue;
    const bool found = note.kind == page::Note::Kind::kFound;
    const cv::Rect tick(x_of(t) - 1, kBarTop_px - (found ? 9 : 4), 3, kBarHeight_px + (found ? 18 : 8));
    cv::rectangle(image, tick, t <= t_s ? colour_of(note.kind) : cv::Scalar(colour_of(note.kind) * 0.55), cv::FILLED);
  }
}

}  // namespace amiss::video::internal
