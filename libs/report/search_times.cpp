#include "report/search_times.hpp"

namespace amiss::report {

double action_s(const SegmentationTimes& times, std::string_view method) {
  return method == kStatic ? times.frame_s : times.region_s;
}

double recomputed_s(const SearchMoment& moment, const SegmentationTimes& times, std::string_view method) {
  return moment.at_s - moment.segmentation_cost_s + moment.segmentations * action_s(times, method);
}

}  // namespace amiss::report
