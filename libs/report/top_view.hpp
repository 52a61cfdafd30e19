// A room seen from above, with what was found in it: a picture as in Figure 5.5 of the thesis.
// in: cloud in the map frame [m], groups of its points with their colour, later ones over earlier ones. out: PNG bytes;
// x to the right, y up, at most kTopViewPixels wide or high. Points higher than 2 m above the floor (the lowest
// hundredth) are left out, so that a ceiling hides nothing; points that are not finite too.
#pragma once

#include <string>
#include <vector>

#include "core/frames.hpp"

namespace amiss::report {

inline constexpr int kTopViewPixels = 1400;

struct MarkedPoints {
  std::vector<std::uint32_t> points;
  Rgb colour;
  std::string label;  // beside its middle; none where empty
};

[[nodiscard]] std::string top_view_png(const Cloud<Map>& cloud, const std::vector<MarkedPoints>& marks);

}  // namespace amiss::report
