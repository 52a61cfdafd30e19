#include "experiment/result.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "experiment/sample_report.hpp"

namespace amiss::experiment {
namespace {

const Trial kTrial{"0123456789abcdef0123", "lab_30", "static", 2, 7, 102, "program"};

TEST(TrialResult, IsReadBack) {
  const std::string json = report::to_json(sample_report(), "");
  const TrialResult result = parse_result(kTrial, result_text(kTrial, json), "r.json");
  EXPECT_FALSE(result.failed);
  EXPECT_TRUE(result.complete());
  EXPECT_EQ(result.segmentations, 8);
  EXPECT_EQ(result.segments_false, 15);
  EXPECT_DOUBLE_EQ(result.simulated_s, 81.52);
  ASSERT_EQ(result.objects.size(), 2U);
  EXPECT_EQ(result.objects[1].segmentations, 8);
  EXPECT_DOUBLE_EQ(result.objects[1].segmentation_cost_s, 48.0);
  const TrialTimes times = parse_times(times_text(json), "t.json");
  EXPECT_DOUBLE_EQ(times.wall_s, 4.0);
  EXPECT_DOUBLE_EQ(times.segmentation_mean_ms, 14.0);
}

TEST(TrialResult, HoldsNothingOfTheClock) {
  report::TidyReport slow = sample_report();
  slow.wall_s = 99.0;
  slow.segmentation_mean_ms = slow.segmentation_max_ms = slow.differencing_mean_ms = slow.differencing_max_ms = 77.0;
  EXPECT_EQ(result_text(kTrial, report::to_json(slow, "")), result_text(kTrial, report::to_json(sample_report(), "")));
}

TEST(TrialResult, NotAllFoundIsNotComplete) {
  report::TidyReport report = sample_report();
  report.objects[1].found = false;
  report.outcome = "time_limit";
  const TrialResult result = parse_result(kTrial, result_text(kTrial, report::to_json(report, "")), "r.json");
  EXPECT_FALSE(result.failed);
  EXPECT_FALSE(result.complete());
}

TEST(TrialResult, FailuresKeepTheirReason) {
  const TrialResult result = parse_result(kTrial, failure_text(kTrial, "ended by signal 11 \xff"), "r.json");
  EXPECT_TRUE(result.failed);
  EXPECT_EQ(result.why.substr(0, 18), "ended by signal 11");
}

TEST(TrialResult, OfAnotherTrialOrBrokenIsRefused) {
  const std::string text = failure_text(kTrial, "x");
  Trial other = kTrial;
  other.seed = 8;
  EXPECT_EQ(test::sentence_of<InputError>([&] { (void)parse_result(other, text, "r.json"); }),
            "r.json: is the result of another trial");
  Trial newer = kTrial;
  newer.program = "newer";
  EXPECT_NE(test::sentence_of<InputError>([&] {
              (void)parse_result(newer, text, "r.json");
            }).find("comes from another program (program) than the plan's (newer)"),
            std::string::npos);
  EXPECT_THROW((void)parse_result(kTrial, text.substr(0, text.size() / 2), "r.json"), InputError);
  std::string changed = text;
  changed.replace(changed.find("\"x\""), 3, "\"y\"");
  EXPECT_EQ(test::sentence_of<InputError>([&] { (void)parse_result(kTrial, changed, "r.json"); }),
            "r.json: was changed since it was written (its sha256 disagrees)");
  EXPECT_THROW((void)parse_times("{}", "t.json"), InputError);
}

}  // namespace
}  // namespace amiss::experiment
