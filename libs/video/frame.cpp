#include "video/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/result.hpp"
#include "video/internal/canvas.hpp"
#include "video/internal/panels.hpp"

namespace amiss::video {

using namespace internal;

namespace {

// The layout: a large view on the left, camera and map on the right, the timeline below.
const cv::Rect kView(16, 16, 832, 588), kCamera(864, 16, 400, 300), kMap(864, 332, 400, 272),
    kTimeline(16, 620, 1248, 84);
constexpr double kFieldOfView_rad = 1.15;

cv::Mat mat_of(const sim::RenderedFrame& frame) {
  cv::Mat bgr(frame.intrinsics.height, frame.intrinsics.width, CV_8UC3);
  std::transform(frame.colour.begin(), frame.colour.end(), bgr.begin<cv::Vec3b>(),
                 [](const Rgb& p) { return cv::Vec3b(p.b, p.g, p.r); });
  return bgr;
}

void draw_camera(cv::Mat panel, std::string_view jpeg) {
  if (!jpeg.empty()) {
    const cv::Mat bytes(1, static_cast<int>(jpeg.size()), CV_8UC1, const_cast<char*>(jpeg.data()));
    const cv::Mat picture = cv::imdecode(bytes, cv::IMREAD_COLOR);
    if (picture.empty()) throw InputError("camera.bin: holds no JPEG where the timeline says one");
    cv::resize(picture, panel, panel.size(), 0, 0, cv::INTER_CUBIC);
  }
  shade(panel, {0, 0, 112, 26}, kBackground, 0.6);
  put_text(panel, "its camera", {10, 18}, 10.0, kText);
}

/// Of a scripted run only what was found is told: not all that its script brings in is to be found.
std::string found_text(const page::Story& story, double t_s) {
  const auto* objects = page::latest(story.objects, t_s);
  if (objects == nullptr || objects->empty()) return "";
  const auto found = std::count_if(objects->begin(), objects->end(), [](const auto& o) { return o.found; });
  const bool scripted = std::any_of(story.notes.begin(), story.notes.end(),
                                    [](const auto& n) { return n.value.kind == page::Note::Kind::kScript; });
  return scripted ? fmt::format("{} found", found) : fmt::format("{} of {} found", found, objects->size());
}

void draw_title(cv::Mat view, const page::Story& story, double t_s) {
  const std::string left = fmt::format("{}, seed {}, {} search", story.world, story.seed, story.method);
  const std::string right = found_text(story, t_s);
  shade(view, {0, 0, view.cols, 36}, kBackground, 0.6);
  const int begin = view.cols - 14 - text_width(right, 13.0);
  put_text(view, wrapped(left, 13.0, begin - 28, 1).front(), {14, 24}, 13.0, kText);
  put_text(view, right, {begin, 24}, 13.0, kGreen * 1.5);
}

}  // namespace

CameraIntrinsics third_person_camera() { return sim::pinhole(kView.width, kView.height, kFieldOfView_rad); }

std::vector<Rgb> compose(const page::Story& story, double t_s, const ThirdPerson& view, std::string_view camera_jpeg) {
  if (!(view.picture.intrinsics == third_person_camera()))
    throw ArgumentError("the third-person view is not of third_person_camera()");
  cv::Mat frame(kFrameHeight, kFrameWidth, CV_8UC3, kBackground);
  for (const cv::Rect& panel : {kCamera, kMap, kTimeline}) frame(panel).setTo(kPanel);
  cv::Mat picture = mat_of(view.picture);
  draw_marks(picture, story, t_s, view);
  draw_title(picture, story, t_s);
  picture.copyTo(frame(kView));
  draw_camera(frame(kCamera), camera_jpeg);
  draw_map(frame(kMap), story, t_s);
  draw_timeline(frame(kTimeline), story, t_s);
  std::vector<Rgb> pixels(frame.total());
  std::transform(frame.begin<cv::Vec3b>(), frame.end<cv::Vec3b>(), pixels.begin(), [](const cv::Vec3b& p) {
    return Rgb{p[2], p[1], p[0]};
  });
  return pixels;
}

}  // namespace amiss::video
