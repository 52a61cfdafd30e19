#include "report/search_times.hpp"

#include <gtest/gtest.h>

namespace amiss::report {
namespace {

TEST(SearchTimes, AreThoseOfTheThesis) {
  EXPECT_EQ(action_s(kSegmentationTimes[0], kStatic), 9.0);
  EXPECT_EQ(action_s(kSegmentationTimes[0], kDynamic), 5.0);
  EXPECT_EQ(action_s(kSegmentationTimes[1], kStatic), 6.0);
  EXPECT_EQ(action_s(kSegmentationTimes[1], kDynamic), 1.0);
  EXPECT_EQ(action_s(kSegmentationTimes[2], kStatic), 0.040);
  EXPECT_EQ(action_s(kSegmentationTimes[2], kDynamic), 0.020);
}

/// 200 s with ten segmentations of 6 s each: 140 s of other things.
TEST(SearchTimes, OnlyTheCostOfSegmentingIsReplaced) {
  const SearchMoment end{200.0, 10, 60.0};
  EXPECT_DOUBLE_EQ(recomputed_s(end, kSegmentationTimes[0], kStatic), 230.0);
  EXPECT_DOUBLE_EQ(recomputed_s(end, kSegmentationTimes[1], kStatic), 200.0);
  EXPECT_DOUBLE_EQ(recomputed_s(end, kSegmentationTimes[2], kStatic), 140.4);
  EXPECT_DOUBLE_EQ(recomputed_s({200.0, 10, 10.0}, kSegmentationTimes[2], kDynamic), 190.2);
  EXPECT_DOUBLE_EQ(recomputed_s({50.0, 0, 0.0}, kSegmentationTimes[0], kDynamic), 50.0);
}

}  // namespace
}  // namespace amiss::report
