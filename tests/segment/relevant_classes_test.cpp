#include "segment/relevant_classes.hpp"

#include <gtest/gtest.h>

namespace amiss::segment {
namespace {

TEST(RelevantClasses, AreThoseOfTheFootnote) {
  int supports = 0;
  for (const NamedSemanticClass& named : kSemanticClasses) supports += may_support(named.value) ? 1 : 0;
  EXPECT_EQ(supports, 11);  // of the 21 classes; shelves, night stand and other structure are not among them
  EXPECT_TRUE(may_support(SemanticClass::kTable));
  EXPECT_TRUE(may_support(SemanticClass{38}));
  EXPECT_FALSE(may_support(SemanticClass::kWall));
  EXPECT_FALSE(may_support(SemanticClass::kUnlabelled));
}

}  // namespace
}  // namespace amiss::segment
