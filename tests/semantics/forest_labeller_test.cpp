#include "semantics/forest_labeller.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "semantics/confusion.hpp"
#include "semantics/forest_training.hpp"
#include "semantics/internal/smoothing.hpp"
#include "semantics/labelled_room.hpp"
#include "semantics/voxel_features.hpp"

namespace amiss::semantics {
namespace {

/// Learnt from three small rooms.
const Forest& small_forest() {
  static const Forest kForest = [] {
    ForestSamples samples;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const auto room = test::labelled_room(seed);
      const VoxelFeatures features = voxel_features(room.cloud, 0.02, 2);
      for (std::size_t i = 0; i < room.classes.size(); i += 7) {
        const auto row = features.of(features.voxels.of_point[i]);
        samples.features.insert(samples.features.end(), row.begin(), row.end());
        samples.classes.push_back(room.classes[i]);
      }
    }
    const ForestTrainingParams params{.trees = 8, .draws = 2000, .depth = 10};
    return train_forest(samples, params, 0.02, 1, 2);
  }();
  return kForest;
}

TEST(ForestLabeller, LabelsARoomThatItHasNotSeen) {
  const auto room = test::labelled_room(9);
  Confusion confusion;
  confusion.add(room.classes, ForestLabeller(small_forest(), "small").label(room.cloud));
  EXPECT_GT(confusion.accuracy(), 0.97);
  EXPECT_GT(confusion.iou(SemanticClass::kTable).value_or(0), 0.9);
  EXPECT_GT(confusion.iou(SemanticClass::kOtherProp).value_or(0), 0.6);
}

TEST(ForestLabeller, ThreadsDoNotMatter) {
  const auto room = test::labelled_room(8);
  ForestLabellerParams one, four;
  one.threads = 1;
  four.threads = 4;
  EXPECT_EQ(ForestLabeller(small_forest(), "small", one).label(room.cloud),
            ForestLabeller(small_forest(), "small", four).label(room.cloud));
}

TEST(ForestLabeller, PointsThatAreNotFiniteAreUnlabelled) {
  auto room = test::labelled_room(7);
  room.cloud.points[5].x() = std::numeric_limits<float>::quiet_NaN();
  const auto labels = ForestLabeller(small_forest(), "small").label(room.cloud);
  ASSERT_EQ(labels.size(), room.classes.size());
  EXPECT_EQ(labels[5], SemanticClass::kUnlabelled);
  EXPECT_NE(labels[6], SemanticClass::kUnlabelled);
  EXPECT_TRUE(ForestLabeller(small_forest(), "small").label({}).empty());
}

TEST(ForestLabeller, SaysWhatItIs) {
  const amiss::test::TemporaryFolder folder;
  save_forest(folder.path() / "mine.bin", small_forest());
  EXPECT_EQ(load_forest_labeller(folder.path() / "mine.bin").identity().to_line(), "forest (mine.bin, learned)");
  EXPECT_THROW((void)load_forest_labeller(folder.path() / "none.bin"), InputError);
  EXPECT_THROW((void)load_forest_labeller(folder.write("text.bin", "hello")), InputError);
}

TEST(Smoothing, NeighboursAgreeAndEdgesStay) {
  // A strip of voxels, white and black halves; one white voxel says the other thing.
  Cloud<Map> cloud;
  for (int x = 0; x < 40; ++x) {
    for (int y = 0; y < 5; ++y) {
      cloud.points.emplace_back(0.01F + 0.02F * static_cast<float>(x), 0.01F + 0.02F * static_cast<float>(y), 0.01F);
      cloud.colours.push_back(x < 20 ? Rgb{255, 255, 255} : Rgb{0, 0, 0});
      cloud.normals.emplace_back(0, 0, 1);
    }
  }
  const Voxels voxels = voxels_of(cloud, 0.02);
  std::vector<float> probabilities(2 * voxels.size());
  for (std::size_t v = 0; v < voxels.size(); ++v) probabilities[2 * v + (v < 100 ? 0 : 1)] = 1.0F;
  std::swap(probabilities[2 * 52], probabilities[2 * 52 + 1]);
  const std::vector<float> result = smoothed(voxels, probabilities, {}, 2);
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    EXPECT_NEAR(result[2 * v] + result[2 * v + 1], 1.0F, 1e-4F);
    EXPECT_GT(result[2 * v + (v < 100 ? 0 : 1)], 0.5F) << v;
  }
  EXPECT_GT(result[2 * 97], 0.9F);  // white, beside black
}

}  // namespace
}  // namespace amiss::semantics
