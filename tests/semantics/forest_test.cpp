#include "semantics/forest.hpp"

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "core/random.hpp"
#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "semantics/voxel_features.hpp"

namespace amiss::semantics {
namespace {

ForestNode decision(std::uint8_t feature, float threshold, std::uint16_t right) {
  ForestNode node;
  node.feature = feature;
  node.threshold = threshold;
  node.right = right;
  return node;
}
ForestNode leaf(std::uint8_t place, std::uint8_t weight, std::uint8_t other = 0, std::uint8_t other_weight = 0) {
  ForestNode node;
  node.shares[0] = {place, weight};
  node.shares[1] = {other, other_weight};
  return node;
}

/// Floor below 0.1, else wall or table by feature 1; the other tree always says table.
Forest small_forest() {
  Forest forest{0.02, {SemanticClass::kWall, SemanticClass::kFloor, SemanticClass::kTable}, {}};
  forest.trees = {{decision(0, 0.1F, 2), leaf(1, 255), decision(1, 0.5F, 4), leaf(0, 200, 2, 55), leaf(2, 255)},
                  {leaf(2, 255)}};
  return forest;
}

std::vector<float> classify(const Forest& forest, float first, float second) {
  std::vector<float> features(kFeatureCount), probabilities(3);
  features[0] = first;
  features[1] = second;
  forest.classify(features, probabilities);
  return probabilities;
}

TEST(Forest, IsTheMeanOfItsTrees) {
  EXPECT_EQ(classify(small_forest(), 0.1F, 0), (std::vector<float>{0, 0.5F, 0.5F}));
  EXPECT_EQ(classify(small_forest(), 0.2F, 1), (std::vector<float>{0, 0, 1}));
  const auto mixed = classify(small_forest(), 0.2F, 0.5F);
  EXPECT_FLOAT_EQ(mixed[0], 200.0F / 510.0F);
  EXPECT_FLOAT_EQ(mixed[2], 310.0F / 510.0F);
}

TEST(Forest, FileReadsBack) {
  const amiss::test::TemporaryFolder folder;
  save_forest(folder.path() / "forest.bin", small_forest());
  const Forest read = load_forest(folder.path() / "forest.bin");
  EXPECT_EQ(forest_bytes(read), forest_bytes(small_forest()));
  EXPECT_EQ(classify(read, 0.2F, 0.5F), classify(small_forest(), 0.2F, 0.5F));
}

TEST(Forest, CutAndChangedFilesAreRefused) {
  const std::string bytes = forest_bytes(small_forest());
  for (std::size_t length = 0; length < bytes.size(); length += 7) {
    EXPECT_THROW((void)parse_forest(bytes.substr(0, length), "f"), InputError) << length;
  }
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 0x11);
    EXPECT_THROW((void)parse_forest(changed, "f"), InputError) << at;
  }
  try {
    (void)parse_forest("P6 640 480", "picture.bin");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "picture.bin: is no forest; a forest written by 'amiss semantics train' is needed");
  }
}

/// With a right hash: what is inside is checked as well.
TEST(Forest, ImpossibleTreesAreRefused) {
  const auto refuses = [](const Forest& forest) {
    EXPECT_THROW((void)parse_forest(forest_bytes(forest), "f"), InputError);
  };
  Forest forest = small_forest();
  forest.trees[0][0].right = 0;  // round and round
  refuses(forest);
  forest = small_forest();
  forest.trees[0][2].right = 5;  // out of the tree
  refuses(forest);
  forest = small_forest();
  forest.trees[0][0].feature = 250;
  refuses(forest);
  forest = small_forest();
  forest.trees[0].pop_back();
  refuses(forest);
  forest = small_forest();
  forest.trees[1][0].shares[0].place = 3;
  refuses(forest);
  forest = small_forest();
  forest.trees[1].clear();
  refuses(forest);
  forest = small_forest();
  forest.classes[0] = static_cast<SemanticClass>(13);
  refuses(forest);
  forest = small_forest();
  forest.trees.clear();
  refuses(forest);
  forest = small_forest();
  forest.voxel_m = 7.0;
  refuses(forest);
}

TEST(Forest, MutantsWithARightHashNeverLeadOutside) {
  const std::string bytes = forest_bytes(small_forest());
  const std::string body = bytes.substr(0, bytes.size() - 64);
  RandomStream random(1, "mutants");
  for (int i = 0; i < 3000; ++i) {
    std::string mutant = body;
    for (int k = 0; k < 2; ++k) mutant[15 + random.below(mutant.size() - 15)] = static_cast<char>(random.next());
    try {
      const Forest forest = parse_forest(mutant + sha256(mutant), "f");
      std::vector<float> features(kFeatureCount, 0.3F), probabilities(forest.classes.size());
      forest.classify(features, probabilities);
    } catch (const InputError&) {
    }
  }
}

}  // namespace
}  // namespace amiss::semantics
