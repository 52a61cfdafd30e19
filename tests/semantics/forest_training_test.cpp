#include "semantics/forest_training.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"
#include "core/result.hpp"
#include "semantics/voxel_features.hpp"

namespace amiss::semantics {
namespace {

/// Two features tell three classes apart; one is rare, and one sample in twenty is labelled wrongly.
ForestSamples samples(std::uint64_t seed, int count) {
  RandomStream random(seed, "samples");
  ForestSamples made;
  for (int i = 0; i < count; ++i) {
    std::vector<float> row(kFeatureCount);
    for (float& value : row) value = static_cast<float>(random.uniform());
    SemanticClass value = row[10] > 0.5F ? SemanticClass::kTable : SemanticClass::kFloor;
    if (row[20] > 0.95F) value = SemanticClass::kOtherProp;
    if (random.uniform() < 0.05) value = SemanticClass::kFloor;
    made.features.insert(made.features.end(), row.begin(), row.end());
    made.classes.push_back(value);
  }
  return made;
}

ForestTrainingParams small() {
  return {.trees = 6, .draws = 800, .depth = 10, .fewest_in_node = 6, .features_of_a_split = 60};
}

TEST(ForestTraining, LearnsWhatTellsClassesApart) {
  const Forest forest = train_forest(samples(1, 3000), small(), 0.02, 1, 2);
  EXPECT_EQ(forest.classes,
            (std::vector<SemanticClass>{SemanticClass::kFloor, SemanticClass::kTable, SemanticClass::kOtherProp}));
  const ForestSamples other = samples(2, 1000);
  int right = 0;
  for (std::size_t i = 0; i < other.classes.size(); ++i) {
    std::vector<float> p(3);
    forest.classify(std::span(other.features).subspan(i * kFeatureCount, kFeatureCount), p);
    EXPECT_NEAR(p[0] + p[1] + p[2], 1.0F, 1e-4F);
    right +=
        forest.classes[static_cast<std::size_t>(std::max_element(p.begin(), p.end()) - p.begin())] == other.classes[i];
  }
  EXPECT_GT(right, 850);
}

TEST(ForestTraining, SameSeedSameBytesForAnyNumberOfThreads) {
  const ForestSamples some = samples(3, 500);
  const auto bytes = [&](std::uint64_t seed, int threads) {
    ForestTrainingParams params = small();
    params.trees = 3;
    return forest_bytes(train_forest(some, params, 0.02, seed, threads));
  };
  EXPECT_EQ(bytes(1, 1), bytes(1, 3));
  EXPECT_NE(bytes(1, 1), bytes(2, 1));
}

TEST(ForestTraining, FileOfATrainedForestIsAccepted) {
  const Forest forest = train_forest(samples(4, 800), small(), 0.02, 1, 2);
  EXPECT_EQ(forest_bytes(parse_forest(forest_bytes(forest), "f")), forest_bytes(forest));
}

TEST(ForestTraining, BadInputIsRefused) {
  EXPECT_THROW((void)train_forest({}, small(), 0.02, 1, 1), ArgumentError);
  ForestSamples one = samples(5, 50);
  std::fill(one.classes.begin(), one.classes.end(), SemanticClass::kWall);
  EXPECT_THROW((void)train_forest(one, small(), 0.02, 1, 1), ArgumentError);
  one.features.pop_back();
  EXPECT_THROW((void)train_forest(one, small(), 0.02, 1, 1), ArgumentError);
  ForestTrainingParams deep = small();
  deep.depth = 60;
  EXPECT_THROW((void)train_forest(samples(6, 100), deep, 0.02, 1, 1), ArgumentError);
}

}  // namespace
}  // namespace amiss::semantics
