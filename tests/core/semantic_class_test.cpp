#include "core/semantic_class.hpp"

#include <gtest/gtest.h>

namespace amiss {
namespace {

TEST(SemanticClassTest, NamesAndValuesBelongToEachOtherAndRise) {
  int last = -1;
  for (const auto& [value, name] : kSemanticClasses) {
    EXPECT_GT(static_cast<int>(value), last);
    last = static_cast<int>(value);
    EXPECT_EQ(to_string(value), name);
    EXPECT_EQ(semantic_class_of(name), value);
  }
  EXPECT_EQ(kSemanticClasses.size(), 22U);
  EXPECT_FALSE(semantic_class_of("lamp").has_value());
  EXPECT_EQ(to_string(static_cast<SemanticClass>(13)), "?");
}

}  // namespace
}  // namespace amiss
