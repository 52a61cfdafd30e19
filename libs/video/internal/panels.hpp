// The parts of a frame, each drawn into its own box.
#pragma once

#include <opencv2/core.hpp>

#include "video/frame.hpp"

namespace amiss::video::internal {

/// Path, regions and objects as marks on the floor of the third-person view, hidden by what stands before them.
void draw_marks(cv::Mat& image, const page::Story& story, double t_s, const ThirdPerson& view);
/// The robot's map from above: x to the right, y up.
void draw_map(cv::Mat image, const page::Story& story, double t_s);
/// The run from its beginning to its end, what happened when, and what happens now.
void draw_timeline(cv::Mat image, const page::Story& story, double t_s);

}  // namespace amiss::video::internal
