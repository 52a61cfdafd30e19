#include "mission/params.hpp"

#include <gtest/gtest.h>

#include <set>

namespace amiss::mission {
namespace {

TEST(Params, KeysAreUniqueAndOfOneGroup) {
  Params params;
  ParamTable table;
  describe(table, params);
  std::set<std::string> keys;
  for (const ParamTable::Row& row : table.rows()) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.key << " stands twice";
    EXPECT_EQ(std::count(row.key.begin(), row.key.end(), '.'), 1) << row.key << " is not group.name";
    EXPECT_FALSE(row.meaning.empty()) << row.key;
  }
  EXPECT_GT(keys.size(), 50U);
}

TEST(Params, DefaultsAreWithinTheirRanges) {
  Params params;
  ParamTable table;
  describe(table, params);
  for (const ParamTable::Row& row : table.rows()) {
    const std::string text = row.print();
    EXPECT_TRUE(row.parse(text)) << row.key << " = " << text << ", allowed: " << row.allowed;
    EXPECT_EQ(row.print(), text) << row.key;
  }
}

}  // namespace
}  // namespace amiss::mission
