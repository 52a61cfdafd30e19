// How long a search takes with other segmentation times than those it was run with, as Section 4.3 of the thesis
// recomputes its own: the simulated cost of each segmentation action is replaced, all else stays.
// Simulated seconds and segmentation actions -> seconds.
#pragma once

#include <array>
#include <string_view>

namespace amiss::report {

/// Of one segmentation action: the whole frame (static method) or a cropped one (dynamic method).
struct SegmentationTimes {
  std::string_view name;
  double frame_s = 0.0, region_s = 0.0;
};

/// Those of the thesis: its robot, its simulation, and the 40 ms and 20 ms that it recomputes with.
inline constexpr std::array<SegmentationTimes, 3> kSegmentationTimes{
    {{"real_robot", 9.0, 5.0}, {"simulation", 6.0, 1.0}, {"fast", 0.04, 0.02}}};

inline constexpr std::string_view kDynamic = "dynamic", kStatic = "static";

/// Of one action of this method.
[[nodiscard]] double action_s(const SegmentationTimes& times, std::string_view method);

/// A moment of a search: the simulated time, how many segmentation actions there were until then, and what they took.
struct SearchMoment {
  double at_s = 0.0;
  int segmentations = 0;
  double segmentation_cost_s = 0.0;
};
[[nodiscard]] double recomputed_s(const SearchMoment& moment, const SegmentationTimes& times, std::string_view method);

}  // namespace amiss::report
