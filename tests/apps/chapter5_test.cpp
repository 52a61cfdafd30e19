// A small version of chapter 5 from nothing: one visit to the smallest room is recorded, reconstructed, annotated and
// judged, by the script that makes the whole table.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/program.hpp"
#include "core/files.hpp"

namespace amiss {
namespace {

namespace fs = std::filesystem;
using test::Ended;

using Rows = std::vector<std::vector<std::string>>;

Rows rows_of(const fs::path& table) {
  Rows rows;
  std::istringstream lines(load_bytes(table));
  for (std::string line; std::getline(lines, line);) {
    auto& row = rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
  }
  return rows;
}

/// F1 of each method, in the rows of a room.
std::map<std::string, double> f1_of(const Rows& rows, const std::string& room) {
  std::map<std::string, double> f1;
  for (const auto& row : rows) {
    if (row.at(0) == room) f1[row.at(1)] = std::stod(row.at(6));
  }
  return f1;
}

struct Chapter5 : testing::Test {
  static void SetUpTestSuite() {
    test::use_test_cache();
    folder = std::make_unique<test::TemporaryFolder>();
    const std::string script = (fs::path(AMISS_SOURCE_DIR) / "tests" / "bench" / "table52.sh").string();
    const std::string at = folder->path().string();
    made = std::system(("bash '" + script + "' '" AMISS_PROGRAM "' '" + at + "' 2 --rooms office_desk --visits 1 >'" +
                        at + "/out' 2>'" + at + "/err'")
                           .c_str());
  }
  static void TearDownTestSuite() { folder.reset(); }
  void SetUp() override { ASSERT_EQ(made, 0) << folder->read("err"); }

  static std::unique_ptr<test::TemporaryFolder> folder;
  static int made;
};
std::unique_ptr<test::TemporaryFolder> Chapter5::folder;
int Chapter5::made = -1;

TEST_F(Chapter5, TheTableHasItsColumnsAndTheFullMethodIsTheBest) {
  EXPECT_NE(folder->read("out").find("3 placed objects have points"), std::string::npos) << folder->read("out");
  const Rows rows = rows_of(folder->path() / "table" / "table52.tsv");
  ASSERT_GT(rows.size(), 1U);
  const std::vector<std::string> columns{"room",      "method", "precision", "precision_sd", "recall",
                                         "recall_sd", "f1",     "f1_sd",     "missed",       "wrong"};
  EXPECT_EQ(rows.front(), columns);
  EXPECT_EQ(rows.back().front(), "average");
  const auto f1 = f1_of(rows, "office_desk"), average = f1_of(rows, "average");
  ASSERT_EQ(f1.size(), 6U) << "methods";
  EXPECT_EQ(average, f1) << "of one room";
  const double full = f1.at("local-verification");
  EXPECT_GT(full, 0.6);
  EXPECT_GT(full, f1.at("octomap"));
  EXPECT_GT(full, f1.at("metaroom"));
}

/// Where everything that only the simulator knows is gone, all comes out as before.
TEST_F(Chapter5, NothingReadsTheTruthButAnnotation) {
  const fs::path made_before = folder->path() / "made" / "office_desk-scene2" / "cloud.ply";
  const fs::path recording = folder->path() / "dataset" / "recordings" / "office_desk" / "scene2";
  fs::remove_all(recording / "truth");
  fs::remove(recording / "groundtruth.txt");
  const Ended again = test::run({"reconstruct", recording.string(), "--out", "again", "--quiet"}, folder->path());
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_TRUE(load_bytes(folder->path() / "again" / "cloud.ply") == load_bytes(made_before));

  fs::remove_all(folder->path() / "dataset");
  const fs::path room = folder->path() / "rooms" / "office_desk";
  fs::remove(room / "Annotations" / "scene1_labels.pcd");
  fs::remove(room / "Annotations" / "scene2_labels.pcd");
  const std::vector<std::string> methods{"--methods", "local-verification", "--labels", "forest"};
  std::vector<std::string> judge{"evaluate", "chapter5", "rooms", "--out", "table_again"};
  judge.insert(judge.end(), methods.begin(), methods.end());
  const Ended judged = test::run(judge, folder->path());
  ASSERT_EQ(judged.status, 0) << judged.err;
  const auto before = f1_of(rows_of(folder->path() / "table" / "table52.tsv"), "average");
  const auto after = f1_of(rows_of(folder->path() / "table_again" / "table52.tsv"), "average");
  EXPECT_EQ(after.at("local-verification"), before.at("local-verification"));

  fs::remove_all(room / "Annotations");
  const Ended detected = test::run({"detect", (room / "scene1.pcd").string(), (room / "scene2.pcd").string(),
                                    "--labels", "forest", "--out", "found"},
                                   folder->path());
  ASSERT_EQ(detected.status, 0) << detected.err;
  const auto found = nlohmann::json::parse(load_bytes(folder->path() / "found" / "objects.json"));
  EXPECT_FALSE(found.at("objects").empty());
}

}  // namespace
}  // namespace amiss
