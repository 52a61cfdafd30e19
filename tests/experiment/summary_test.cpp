#include "experiment/summary.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "experiment/sample_results.hpp"

namespace amiss::experiment {
namespace {

const std::vector<TrialResult> kResults{
    sample_result("dynamic", 1, {10.0, 20.0}, 2, 1.0), sample_result("dynamic", 2, {10.0, 24.0}, 2, 1.0),
    sample_result("static", 1, {30.0, 60.0}, 2, 6.0), sample_failure("static", 2, 2)};

std::vector<Trial> trials() {
  std::vector<Trial> planned;
  for (const TrialResult& r : kResults) planned.push_back(r.trial);
  Trial missing = planned[0];
  missing.id = "missing";
  missing.seed = 3;
  planned.push_back(missing);
  return planned;
}

Spec spec() {
  Spec s;
  s.worlds = {"lab_30"};
  s.objects = {2};
  return s;
}

/// The field of a row by the name of its column.
std::string at(const Table& table, std::size_t row, const std::string& column) {
  const auto found = std::find(table.heading.begin(), table.heading.end(), column);
  EXPECT_NE(found, table.heading.end()) << column;
  return table.rows.at(row).at(static_cast<std::size_t>(found - table.heading.begin()));
}

TEST(Summary, CountsWhatFailedAndWhatIsMissing) {
  const Table table = summary_table(trials(), kResults);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(at(table, 0, "method"), "dynamic");
  EXPECT_EQ(at(table, 0, "trials"), "3");
  EXPECT_EQ(at(table, 0, "missing"), "1");
  EXPECT_EQ(at(table, 0, "all_found"), "2");
  EXPECT_EQ(at(table, 0, "segmentations_an_object"), "1");
  EXPECT_EQ(at(table, 0, "time_simulation_s_median"), "22");
  EXPECT_EQ(at(table, 1, "failed"), "1");
  EXPECT_EQ(at(table, 1, "time_simulation_s_q1"), "inf") << "half of them did not find all";
  EXPECT_EQ(summary_table(trials(), {}).rows[0][8], "-");
}

TEST(Summary, RowsAreAsLongAsTheHeading) {
  for (const auto& results : {kResults, std::vector<TrialResult>()}) {
    for (const Table& table : {summary_table(trials(), results), short_summary(trials(), results),
                               statistics_table(spec(), results), short_statistics(spec(), results)}) {
      for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.heading.size());
    }
  }
}

TEST(Statistics, ARowForEachMeasure) {
  const Table table = statistics_table(spec(), kResults);
  ASSERT_EQ(table.rows.size(), measures().size());
  EXPECT_EQ(at(table, 2, "measure"), "time_simulation_s");
  EXPECT_EQ(at(table, 2, "dynamic_median"), "22");
  EXPECT_EQ(at(table, 2, "difference_n"), "2");
  EXPECT_EQ(at(table, 2, "difference_q1"), "inf");
  EXPECT_EQ(at(table, 2, "difference_low95"), "40");
  EXPECT_EQ(at(table, 2, "p"), "0.5");
  EXPECT_EQ(at(table, 2, "p_is"), "exact");
  EXPECT_EQ(at(table, 2, "rank_biserial"), "1");
  EXPECT_EQ(statistics_table(spec(), kResults).rows, table.rows) << "drawn from a stream of this name";
  EXPECT_EQ(at(statistics_table(spec(), {}), 0, "p"), "-");
}

}  // namespace
}  // namespace amiss::experiment
