#include "segment/relevant_classes.hpp"

#include <algorithm>
#include <array>

namespace amiss::segment {

namespace {

constexpr std::array<std::uint8_t, 14> kSupports = {2, 3, 4, 5, 6, 7, 10, 12, 14, 15, 32, 38, 39, 40};

}  // namespace

bool may_support(SemanticClass value) {
  return std::find(kSupports.begin(), kSupports.end(), static_cast<std::uint8_t>(value)) != kSupports.end();
}

}  // namespace amiss::segment
