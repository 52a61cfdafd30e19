// report.html: the page with a run inside, one file that opens without a server and without a network.
// Lines of a timeline, its pictures, texts by name -> HTML of less than kMostBytes. It holds the run's end and no more
// of the way there than fits: poses thinned to kMostPoses, events of a kind that takes more than kMostOfAKind bytes to
// what fits, evenly over time and the last one always (the voxels of the map to what is occupied at the end, marked
// "merged"), and into the room that is left pictures: the last frame, examinations, up to kMostFrames spread over the
// run. Where too little room is left for pictures, every kind is given half as much until it is enough; maps that do
// not fit then lose their upper layers, and a log event says so. InputError for lines that are no timeline.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "page/events.hpp"

namespace amiss::page {

inline constexpr std::size_t kMostBytes = 3'000'000, kMostOfAKind = 250'000, kLeastForPictures = 800'000;
inline constexpr std::size_t kMostPoses = 1500, kMostFrames = 24;

struct ReportPage {
  std::vector<std::string> lines;             // of timeline.jsonl
  std::function<std::string(Slice)> picture;  // JPEG bytes
  std::map<std::string, std::string> texts;   // "params.yaml" -> what stands in it
  std::string libraries = {};                 // "Eigen 3.4.0, ...": shown beside the program's version
};

[[nodiscard]] std::string to_html(const ReportPage& page);

}  // namespace amiss::page
