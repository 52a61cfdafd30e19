#include "core/result.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace amiss {
namespace {

TEST(Result, HoldsAValueOrAReason) {
  const Result<int> good(3);
  const auto bad = Result<int>::failure("no way");
  ASSERT_TRUE(good);
  EXPECT_EQ(*good, 3);
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.why(), "no way");
}

TEST(Result, ValueAndReasonMayBeOfTheSameType) {
  EXPECT_TRUE(Result<std::string>("value"));
  EXPECT_FALSE(Result<std::string>::failure("reason"));
}

TEST(Result, HoldsWhatCanOnlyBeMoved) {
  Result<std::unique_ptr<int>> owner(std::make_unique<int>(5));
  ASSERT_TRUE(owner);
  EXPECT_EQ(**owner, 5);
}

}  // namespace
}  // namespace amiss
