#include "core/params.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "segment/segment.hpp"
#include "segment/support_planes.hpp"

namespace amiss::segment {
namespace {

TEST(Params, AreReadByTheirNames) {
  Params params;
  ParamTable table;
  describe(table, params);
  EXPECT_EQ(params.crop_margin_m, 0.15);  // Table 4.1
  table.set("segment.crop_margin", "0.2", "test");
  EXPECT_EQ(params.crop_margin_m, 0.2);
  EXPECT_THROW(table.set("segment.crop_margin", "-1", "test"), ArgumentError);
}

TEST(Params, OfPlanesAreThoseOfTable51) {
  SupportPlaneParams params;
  ParamTable table;
  describe(table, params);
  EXPECT_EQ(params.distance_m, 0.01);
  EXPECT_DOUBLE_EQ(params.max_tilt_rad, radians(5.0));
  table.set("planes.max_tilt", "10", "test");
  EXPECT_DOUBLE_EQ(params.max_tilt_rad, radians(10.0));
}

}  // namespace
}  // namespace amiss::segment
