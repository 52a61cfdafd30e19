#include "core/params.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "knowledge/knowledge_base.hpp"

namespace amiss::knowledge {
namespace {

TEST(Params, AreReadByTheirNames) {
  Params params;
  ParamTable table;
  describe(table, params);
  table.set("knowledge.same_overlap", "0.5", "test");
  EXPECT_EQ(params.same_overlap, 0.5);
  EXPECT_THROW(table.set("knowledge.same_overlap", "2", "test"), ArgumentError);
}

}  // namespace
}  // namespace amiss::knowledge
