#include "core/params.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "localize/laser_mapper.hpp"
#include "localize/localizer.hpp"

namespace amiss::localize {
namespace {

TEST(Params, AreReadByTheirNames) {
  LocalizerParams localizer;
  LaserMapperParams mapper;
  ParamTable table;
  describe(table, localizer);
  describe(table, mapper);
  table.set("localize.particles", "123", "test");
  table.set("laser_mapper.key_angle", "20", "test");
  EXPECT_EQ(localizer.particles, 123);
  EXPECT_NEAR(mapper.key_angle_rad, radians(20.0), 1e-12);
  EXPECT_THROW(table.set("localize.particles", "3", "test"), ArgumentError);
}

}  // namespace
}  // namespace amiss::localize
