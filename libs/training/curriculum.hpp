// Rooms made up for training -> samples of voxels -> a forest for semantics/forest_labeller.hpp.
// Room after room of its own random stream, in several threads; the same seed gives the same forest, byte for byte, for
// any number of them. Walls and floors are many and alike, so at most so many voxels of a class are taken from a room.
#pragma once

#include <functional>

#include "core/params.hpp"
#include "semantics/forest_training.hpp"
#include "training/room.hpp"
#include "training/sampler.hpp"

namespace amiss::training {

struct CurriculumParams {
  int rooms = 40;
  int stands_of_room = 10;    // places from which the camera looks round
  int voxels_of_class = 250;  // of one room
  double voxel_m = 0.02;
  SamplerParams sampler;
  semantics::ForestTrainingParams forest;
};
void describe(ParamTable& table, CurriculumParams& params);

/// The room of that number, and what the camera sees of it.
[[nodiscard]] LabelledCloud training_cloud(const CurriculumParams& params, const world::Catalogue& catalogue,
                                           const world::ClassTable& classes, std::uint64_t seed, int number);

/// `done` is called with the number of rooms that are, one call at a time.
[[nodiscard]] semantics::Forest train(const CurriculumParams& params, const world::Catalogue& catalogue,
                                      const world::ClassTable& classes, std::uint64_t seed, int threads,
                                      const std::function<void(int)>& done = {});

}  // namespace amiss::training
