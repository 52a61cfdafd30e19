#include "score/expectation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <type_traits>

namespace amiss::score {
namespace {

RunRecord run_of_a_kind() {
  RunRecord run;
  run.end = "explored";
  run.exit_status = 0;
  run.found_at_s = {{"mug", 12.345}};
  run.navigation_errors = {{"no_path", 2}};
  run.detected = {"mug", "ball"};
  run.category = {{"mug", "novel"}};
  run.numbers = {{"collisions", 0.0}, {"recovery", std::numeric_limits<double>::infinity()}, {"plans", 3.0}};
  return run;
}

/// The keys of the expectations that failed.
std::vector<std::string> failed(const Expectations& expected, const RunRecord& run = run_of_a_kind()) {
  std::vector<std::string> keys;
  for (const Finding& finding : judge(expected, run)) {
    EXPECT_FALSE(finding.sentence.empty());
    if (!finding.holds) keys.push_back(finding.what);
  }
  return keys;
}

using Keys = std::vector<std::string>;

/// Nothing is expected but this.
template <class Member>
Expectations only(Member Expectations::*member, const std::type_identity_t<Member>& value) {
  Expectations expected;
  expected.*member = value;
  return expected;
}

TEST(Expectation, WhatHoldsHolds) {
  Expectations expected;
  expected.found = {"mug"};
  expected.not_found = {"ball"};
  expected.detected = {"mug", "ball"};
  expected.not_detected = {"plate"};
  expected.found_by_s = {{"mug", 13.0}};
  expected.category = {{"mug", "novel"}};
  expected.end = {"found", "explored"};
  expected.exit_status = 0;
  expected.numbers = {{"collisions", {{}, 0.0}}, {"plans", {3.0, 3.0}}};
  EXPECT_EQ(failed(expected), Keys{});
  EXPECT_EQ(judge(expected, run_of_a_kind()).size(), 12U);
}

TEST(Expectation, EachFailsAlone) {
  EXPECT_EQ(failed(only(&Expectations::found, {"ball"})), Keys{"found"});
  EXPECT_EQ(failed(only(&Expectations::not_found, {"mug"})), Keys{"not_found"});
  EXPECT_EQ(failed(only(&Expectations::detected, {"plate"})), Keys{"detected"});
  EXPECT_EQ(failed(only(&Expectations::not_detected, {"ball"})), Keys{"not_detected"});
  EXPECT_EQ(failed(only(&Expectations::found_by_s, {{"mug", 12.0}})), Keys{"found_by"});
  EXPECT_EQ(failed(only(&Expectations::found_by_s, {{"ball", 1e6}})), Keys{"found_by"});
  EXPECT_EQ(failed(only(&Expectations::category, {{"ball", "novel"}})), Keys{"category"});
  EXPECT_EQ(failed(only(&Expectations::end, {"found"})), Keys{"end"});
  EXPECT_EQ(failed(only(&Expectations::exit_status, 1)), Keys{"exit_status"});
  EXPECT_EQ(failed(only(&Expectations::why, {"laser stuck"})), Keys{"why"});
  EXPECT_EQ(failed(only(&Expectations::navigation_errors, {{"blocked", {1.0, {}}}})), Keys{"navigation_errors"});
  EXPECT_EQ(failed(only(&Expectations::navigation_errors, {{"no_path", {{}, 1.0}}})), Keys{"navigation_errors"});
  EXPECT_EQ(failed(only(&Expectations::numbers, {{"plans", {4.0, {}}}})), Keys{"plans"});
  EXPECT_EQ(failed(only(&Expectations::numbers, {{"plans", {{}, 2.0}}})), Keys{"plans"});
}

TEST(Expectation, NeverIsLaterThanAnyLimitAndWhatIsNotMeasuredFails) {
  EXPECT_EQ(failed(only(&Expectations::numbers, {{"recovery", {{}, 1e9}}})), Keys{"recovery"});
  EXPECT_EQ(failed(only(&Expectations::numbers, {{"coverage", {0.0, {}}}})), Keys{"coverage"});
  RunRecord run = run_of_a_kind();
  run.numbers["plans"] = std::nan("");
  EXPECT_EQ(failed(only(&Expectations::numbers, {{"plans", {{}, 9.0}}}), run), Keys{"plans"});
}

TEST(Expectation, EventsMustHappen) {
  RunRecord run = run_of_a_kind();
  EXPECT_EQ(failed({}, run), Keys{});
  run.not_happened = {"mug is taken away"};
  EXPECT_EQ(failed({}, run), Keys{"events"});
}

TEST(Expectation, NumbersHaveDistinctNames) {
  std::set<std::string_view> names;
  for (const NumberRow& row : number_rows()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_FALSE(row.meaning.empty());
  }
}

}  // namespace
}  // namespace amiss::score
