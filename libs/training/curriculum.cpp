#include "training/curriculum.hpp"

#include <algorithm>
#include <map>
#include <mutex>

#include "semantics/parallel.hpp"
#include "semantics/voxel_features.hpp"

namespace amiss::training {

namespace {

constexpr double kLowestEye_m = 1.0, kHighestEye_m = 1.4, kRobotRadius_m = 0.25;
constexpr int kTries = 60;

std::vector<Transform<World, Camera>> views_of(const TrainingRoom& room, int stands, RandomStream& random) {
  std::vector<Transform<World, Camera>> views;
  const double eye_m = random.uniform(kLowestEye_m, kHighestEye_m);
  for (int i = 0; i < stands; ++i) {
    for (int tries = 0; tries < kTries; ++tries) {
      const Pose2<World, Base> stand{random.uniform(0, room.size_m.x()), random.uniform(0, room.size_m.y()),
                                     random.uniform(-3.14, 3.14)};
      if (!room.is_free(stand.position(), kRobotRadius_m)) continue;
      for (const Transform<World, Camera>& view : views_around(stand, eye_m)) views.push_back(view);
      break;
    }
  }
  return views;
}

/// The majority of a voxel's points; kUnlabelled for a tie with it.
std::vector<SemanticClass> classes_of(const semantics::Voxels& voxels, const std::vector<SemanticClass>& of_points) {
  std::vector<std::map<SemanticClass, int>> counts(voxels.size());
  for (std::size_t i = 0; i < of_points.size(); ++i) {
    if (voxels.of_point[i] != semantics::Voxels::kNone) ++counts[voxels.of_point[i]][of_points[i]];
  }
  std::vector<SemanticClass> classes;
  for (const auto& count : counts) {
    const auto most =
        std::max_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    classes.push_back(most == count.end() ? SemanticClass::kUnlabelled : most->first);
  }
  return classes;
}

semantics::ForestSamples samples_of(const LabelledCloud& room, const CurriculumParams& params, RandomStream& random) {
  const semantics::VoxelFeatures features = semantics::voxel_features(room.cloud, params.voxel_m, 1);
  const std::vector<SemanticClass> classes = classes_of(features.voxels, room.classes);
  std::map<SemanticClass, std::vector<std::size_t>> members;
  for (std::size_t v = 0; v < classes.size(); ++v) {
    if (classes[v] != SemanticClass::kUnlabelled) members[classes[v]].push_back(v);
  }
  semantics::ForestSamples samples;
  for (auto& [value, voxels] : members) {
    const std::size_t take = std::min(voxels.size(), static_cast<std::size_t>(params.voxels_of_class));
    for (std::size_t i = 0; i < take; ++i) {
      std::swap(voxels[i], voxels[i + random.below(voxels.size() - i)]);
      const auto row = features.of(voxels[i]);
      samples.features.insert(samples.features.end(), row.begin(), row.end());
      samples.classes.push_back(value);
    }
  }
  return samples;
}

RandomStream stream_of(std::uint64_t seed, int number) {
  return RandomStream(seed, "training/room " + std::to_string(number));
}

}  // namespace

void describe(ParamTable& table, CurriculumParams& p) {
  table.integer("training.rooms", p.rooms, 1, 10000, "rooms that are made up and looked at");
  table.integer("training.stands", p.stands_of_room, 1, 100, "places in a room from which the camera looks round");
  table.integer("training.voxels_of_class", p.voxels_of_class, 1, 100000, "voxels of a class taken from a room");
  table.number("training.voxel", p.voxel_m, "m", 0.01, 0.05, "edge of the voxels that are labelled");
  table.integer("training.trees", p.forest.trees, 1, 500, "trees of the forest");
  table.integer("training.draws", p.forest.draws, 100, 1000000, "samples that a tree sees");
  table.integer("training.depth", p.forest.depth, 1, 24, "deepest node of a tree");
  table.integer("training.fewest", p.forest.fewest_in_node, 1, 1000, "samples below which a node is not split");
  table.integer("training.features", p.forest.features_of_a_split, 1, static_cast<int>(semantics::kFeatureCount),
                "features that a split may choose from");
}

LabelledCloud training_cloud(const CurriculumParams& params, const world::Catalogue& catalogue,
                             const world::ClassTable& classes, std::uint64_t seed, int number) {
  RandomStream random = stream_of(seed, number);
  const TrainingRoom room = random_room(catalogue, random);
  const auto views = views_of(room, params.stands_of_room, random);
  return sampled_cloud(room.world, classes, views, params.sampler, random);
}

semantics::Forest train(const CurriculumParams& params, const world::Catalogue& catalogue,
                        const world::ClassTable& classes, std::uint64_t seed, int threads,
                        const std::function<void(int)>& done) {
  std::vector<semantics::ForestSamples> of_room(static_cast<std::size_t>(params.rooms));
  std::mutex mutex;
  int rooms_done = 0;
  semantics::in_parallel(of_room.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      RandomStream random = stream_of(seed, static_cast<int>(r)).child("samples");
      of_room[r] = samples_of(training_cloud(params, catalogue, classes, seed, static_cast<int>(r)), params, random);
      const std::scoped_lock lock(mutex);
      if (done) done(++rooms_done);
    }
  });
  semantics::ForestSamples all;
  for (semantics::ForestSamples& samples : of_room) {
    all.features.insert(all.features.end(), samples.features.begin(), samples.features.end());
    all.classes.insert(all.classes.end(), samples.classes.begin(), samples.classes.end());
    samples = {};
  }
  return semantics::train_forest(all, params.forest, params.voxel_m, seed, threads);
}

}  // namespace amiss::training
