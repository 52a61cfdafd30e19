#include "core/params.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "segment/segment.hpp"

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

}  // namespace
}  // namespace amiss::segment
