// `amiss semantics` as its users see it: a forest trained, clouds labelled in each of the ways, a room measured.
#include <gtest/gtest.h>

#include "apps/program.hpp"
#include "core/files.hpp"
#include "core/semantic_class.hpp"
#include "dataset/cloud_files.hpp"
#include "semantics/confusion.hpp"

namespace amiss {
namespace {

namespace fs = std::filesystem;
using test::Ended;

Ended run_semantics(const fs::path& folder, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"semantics"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return test::run(words, folder);
}

/// A floor, half of it told to be a table.
void write_cloud(const fs::path& file) {
  dataset::CloudFile cloud;
  cloud.fields.push_back({"label", {}});
  for (int x = 0; x < 100; ++x) {
    for (int y = 0; y < 100; ++y) {
      cloud.mesh.vertices.points.emplace_back(0.005F + 0.01F * static_cast<float>(x),
                                              0.005F + 0.01F * static_cast<float>(y), 0.0F);
      cloud.mesh.vertices.colours.push_back({120, 90, 60});
      cloud.mesh.vertices.normals.emplace_back(0, 0, 1);
      cloud.fields[0].values.push_back(x < 50 ? 2 : 7);
    }
  }
  dataset::save_cloud(file, cloud);
}

std::size_t count(const dataset::CloudFile& cloud, SemanticClass value) {
  const auto& labels = cloud.field("label")->values;
  return static_cast<std::size_t>(std::count(labels.begin(), labels.end(), static_cast<double>(value)));
}

TEST(Semantics, SameSeedSameForest) {
  const test::TemporaryFolder folder;
  const auto train = [&](const std::string& out, const std::string& threads) {
    return run_semantics(folder.path(),
                         {"train", "--out", out, "--seed", "3", "-j", threads, "--set", "training.rooms=2", "--set",
                          "training.stands=1", "--set", "training.trees=3", "--set", "training.draws=500"});
  };
  const Ended one = train("one.bin", "1");
  ASSERT_EQ(one.status, 0) << one.err;
  ASSERT_EQ(train("two.bin", "2").status, 0);
  EXPECT_EQ(load_bytes(folder.path() / "one.bin"), load_bytes(folder.path() / "two.bin"));
}

TEST(Semantics, TheForestThatComesWithItKnowsAFloor) {
  const test::TemporaryFolder folder;
  write_cloud(folder.path() / "cloud.ply");
  const Ended ended = run_semantics(folder.path(), {"label", "cloud.ply", "--out", "labelled.ply"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.err.find("10000 points labelled by forest (forest.bin, learned)"), std::string::npos) << ended.err;
  const dataset::CloudFile labelled = dataset::load_cloud(folder.path() / "labelled.ply");
  EXPECT_GT(count(labelled, SemanticClass::kFloor), 9000U);
  EXPECT_EQ(labelled.notes, std::vector<std::string>{"amiss labels: forest (forest.bin, learned)"});
}

TEST(Semantics, TheTruthIsMarkedAsNotLearned) {
  const test::TemporaryFolder folder;
  write_cloud(folder.path() / "cloud.ply");
  const Ended ended =
      run_semantics(folder.path(), {"label", "cloud.ply", "--truth", "cloud.ply", "--out", "labelled.pcd"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.err.find("not learned"), std::string::npos) << ended.err;
  const dataset::CloudFile labelled = dataset::load_cloud(folder.path() / "labelled.pcd");
  EXPECT_EQ(count(labelled, SemanticClass::kFloor), 5000U);
  EXPECT_EQ(count(labelled, SemanticClass::kTable), 5000U);
  const std::vector<std::string> note{"amiss labels: rendered (the simulator's own classes, spoiled, not learned)"};
  EXPECT_EQ(labelled.notes, note);
  // Labelled once more, it says who did it last.
  ASSERT_EQ(run_semantics(folder.path(), {"label", "labelled.pcd", "--out", "again.ply"}).status, 0);
  EXPECT_EQ(dataset::load_cloud(folder.path() / "again.ply").notes,
            std::vector<std::string>{"amiss labels: forest (forest.bin, learned)"});
}

TEST(Semantics, BadInputIsOneSentence) {
  const test::TemporaryFolder folder;
  write_cloud(folder.path() / "cloud.ply");
  folder.write("bad.bin", "not a forest");
  folder.write("bad.yaml", "network: bad.bin\ninput: [32, 24]\nclasses: [wall]\n");
  const auto fails = [&](std::vector<std::string> more, int status, const std::string& says) {
    more.insert(more.begin(), {"label", "cloud.ply", "--out", "labelled.ply"});
    const Ended ended = run_semantics(folder.path(), more);
    EXPECT_EQ(ended.status, status) << ended.err;
    EXPECT_NE(ended.err.find(says), std::string::npos) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_FALSE(fs::exists(folder.path() / "labelled.ply"));
  };
  fails({"--model", "bad.bin"}, 3, "bad.bin: is no forest");
  fails({"--model", "none.bin"}, 3, "none.bin");
  fails({"--network", "bad.yaml", "--recording", "."}, 3, "bad.bin: this is no ONNX network");
  fails({"--network", "bad.yaml"}, 2, "--recording");
  fails({"--intrinsics", "500,500,320,240"}, 2, "--intrinsics and --depth-scale");
  fails({"--model", "bad.bin", "--truth", "cloud.ply"}, 2, "one of --model, --network and --truth");
  fails({"--set", "semantics.forest.round=3"}, 2, "semantics.forest.rounds");
}

TEST(Semantics, EvaluationTellsTheIouOfEachClass) {
  const test::TemporaryFolder folder;
  const Ended ended =
      run_semantics(folder.path(), {"evaluate", "--rooms", "office_desk", "--confusion", "confusion.tsv"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("labeller: forest (forest.bin, learned)"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("otherprop"), std::string::npos) << ended.out;
  const auto confusion = semantics::load_confusion(folder.path() / "confusion.tsv");
  EXPECT_GT(confusion.iou(SemanticClass::kFloor).value_or(0), 0.9);
  EXPECT_GT(confusion.iou(SemanticClass::kOtherProp).value_or(0), 0.2);
  EXPECT_GT(confusion.mean_iou(), 0.3);
}

}  // namespace
}  // namespace amiss
