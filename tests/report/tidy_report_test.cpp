#include "report/tidy_report.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace amiss::report {
namespace {

using nlohmann::json;

TidyReport sample() {
  TidyReport report;
  report.version = "0.1.0";
  report.world = "lab_30";
  report.seed = 5;
  report.method = "dynamic";
  report.outcome = "found";
  report.objects = {{"mug_1", "mug", {1.0, 2.0, 0.04}, true, 61.5, 0.0123, true}, {"ball_1", "ball", {3, 4, 0.1}}};
  report.collisions = {{12.0, "base", "chair_2", {0.5, 0.5, 0.2}}};
  report.simulated_s = 100.0;
  report.wall_s = 4.0;
  report.segmentation_actions = 3;
  report.segmentation_cost_s = 3.0;
  report.differencing_calls = 10;
  report.differencing_mean_ms = 0.3;
  return report;
}

json parsed(const TidyReport& report, std::string_view artefacts = "") {
  return json::parse(to_json(report, artefacts));
}

TEST(TidyReport, HoldsWhatIsPromised) {
  const json report = parsed(sample());
  for (const char* key : {"schema",         "version",        "world",
                          "seed",           "method",         "outcome",
                          "objects_placed", "objects_found",  "segmentation_actions",
                          "regions",        "view_triangles", "coverage",
                          "collisions",     "distance_m",     "time",
                          "localization",   "differencing",   "objects",
                          "digest",         "segmentation"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  EXPECT_EQ(report["objects_placed"], 2);
  EXPECT_EQ(report["objects_found"], 1);
  EXPECT_EQ(report["collisions"], 1);
  EXPECT_EQ(report["time"]["real_time_factor"], 25.0);
  EXPECT_EQ(report["objects"][0]["name"], "mug_1");
  EXPECT_EQ(report["objects"][0]["error_m"], 0.0123);
  EXPECT_TRUE(report["objects"][1]["found_at_s"].is_null()) << "never found, so never at 0 s";
  EXPECT_TRUE(report["objects"][1]["error_m"].is_null());
  EXPECT_EQ(report["time"]["search_s"], (json{{"real_robot", 112.0}, {"simulation", 100.0}, {"fast", 97.06}}));
  EXPECT_EQ(report["digest"].get<std::string>().size(), 64U);
}

TEST(TidyReport, SaysWhyAndWhichErrorsWhereThereAreAny) {
  EXPECT_FALSE(parsed(sample()).contains("why"));
  EXPECT_FALSE(parsed(sample()).contains("navigation_errors"));
  TidyReport report = sample();
  report.outcome = "sensor_lost";
  report.why = "laser stuck";
  report.navigation_errors = {{"blocked", 2}, {"sensor_lost", 1}};
  EXPECT_EQ(parsed(report)["why"], "laser stuck");
  EXPECT_EQ(parsed(report)["navigation_errors"], (json{{"blocked", 2}, {"sensor_lost", 1}}));
  EXPECT_NE(to_table(report).find("sensor_lost: laser stuck"), std::string::npos);
}

TEST(TidyReport, DigestLeavesWallTimeOut) {
  TidyReport slow = sample();
  slow.wall_s = 99.0;
  slow.differencing_mean_ms = 7.0;
  slow.differencing_max_ms = 8.0;
  slow.segmentation_mean_ms = 9.0;
  slow.segmentation_max_ms = 10.0;
  EXPECT_NE(parsed(slow)["time"], parsed(sample())["time"]);
  EXPECT_EQ(parsed(slow)["digest"], parsed(sample())["digest"]);
}

TEST(TidyReport, DigestCoversAllElse) {
  const std::string digest = parsed(sample())["digest"];
  EXPECT_NE(parsed(sample(), "map")["digest"], digest) << "artefacts";
  const auto changed = [&](auto change) {
    TidyReport report = sample();
    change(report);
    return parsed(report)["digest"] != digest;
  };
  EXPECT_TRUE(changed([](TidyReport& r) { r.seed = 6; }));
  EXPECT_TRUE(changed([](TidyReport& r) { r.simulated_s += 0.02; }));
  EXPECT_TRUE(changed([](TidyReport& r) { r.objects[0].error_m += 1e-5; }));
  EXPECT_TRUE(changed([](TidyReport& r) { r.collisions.clear(); }));
  EXPECT_TRUE(changed([](TidyReport& r) { r.differencing_calls = 11; }));
  EXPECT_TRUE(changed([](TidyReport& r) { r.outcome = "explored"; }));
}

TEST(TidyReport, EmptyRunIsJsonToo) {
  TidyReport report;
  report.rmse_m = std::numeric_limits<double>::quiet_NaN();
  const json read = parsed(report);
  EXPECT_EQ(read["objects_placed"], 0);
  EXPECT_TRUE(read["localization"]["rmse_m"].is_null());
  EXPECT_EQ(read["time"]["real_time_factor"], 0.0);
}

TEST(TidyReport, TableNamesEveryObject) {
  const std::string table = to_table(sample());
  EXPECT_NE(table.find("mug_1"), std::string::npos);
  EXPECT_NE(table.find("ball_1"), std::string::npos);
  EXPECT_NE(table.find("1 of 2 found"), std::string::npos);
  EXPECT_NE(table.find("25 times real time"), std::string::npos);
}

}  // namespace
}  // namespace amiss::report
