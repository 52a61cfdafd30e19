#include "training/curriculum.hpp"

#include <gtest/gtest.h>

#include "semantics/confusion.hpp"
#include "semantics/forest_labeller.hpp"
#include "training/made_up.hpp"

namespace amiss::training {
namespace {

/// As little as it takes to tell walls from floors.
CurriculumParams small() {
  CurriculumParams params;
  params.rooms = 4;
  params.stands_of_room = 2;
  params.voxels_of_class = 150;
  params.forest.trees = 6;
  params.forest.draws = 2000;
  params.forest.depth = 12;
  return params;
}

TEST(Curriculum, TeachesWhatHoldsInARoomNotSeen) {
  int calls = 0;
  const semantics::Forest forest = train(small(), test::toys(), test::classes(), 1, 2, [&](int) { ++calls; });
  EXPECT_EQ(calls, 4);
  const LabelledCloud other = training_cloud(small(), test::toys(), test::classes(), 2, 0);
  semantics::Confusion confusion;
  confusion.add(other.classes, semantics::ForestLabeller(forest, "small").label(other.cloud));
  EXPECT_GT(confusion.iou(SemanticClass::kFloor).value_or(0), 0.8);
  EXPECT_GT(confusion.accuracy(), 0.5);
}

TEST(Curriculum, ThreadsDoNotMatter) {
  CurriculumParams params = small();
  params.rooms = 2;
  params.stands_of_room = 1;
  params.forest.trees = 4;
  params.forest.draws = 600;
  const auto bytes = [&](std::uint64_t seed, int threads) {
    return semantics::forest_bytes(train(params, test::toys(), test::classes(), seed, threads));
  };
  const std::string one = bytes(1, 1);
  EXPECT_EQ(one, bytes(1, 2));
  EXPECT_NE(one, bytes(2, 2));
}

}  // namespace
}  // namespace amiss::training
