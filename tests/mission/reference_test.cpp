#include "mission/reference.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"

namespace amiss::mission {
namespace {

Reference sample() {
  Reference reference{FloorGrid(0.05, {-1.0, -2.0}, 60, 40, Occupancy::kFree), mapping::VoxelMap(),
                      mapping::VoxelMap()};
  reference.floor.set({3, 4}, Occupancy::kOccupied);
  reference.floor.set({5, 6}, Occupancy::kUnknown);
  for (int x = -10; x < 10; ++x) {
    for (int z = 0; z < 5; ++z) reference.mapped.set({x, 2, z}, z < 2 ? Occupancy::kOccupied : Occupancy::kFree);
  }
  reference.reference = mapping::dilated(reference.mapped, 1);
  return reference;
}

TEST(Reference, SavedAndLoadedIsTheSame) {
  const test::TemporaryFolder folder;
  const Reference saved = sample();
  save_reference(folder.path(), saved);
  const Reference loaded = load_reference(folder.path(), {});
  EXPECT_EQ(loaded.floor, saved.floor);
  EXPECT_EQ(loaded.mapped.counts(), saved.mapped.counts());
  EXPECT_EQ(loaded.mapped.voxels(Occupancy::kOccupied), saved.mapped.voxels(Occupancy::kOccupied));
  EXPECT_EQ(loaded.reference.voxels(Occupancy::kOccupied), saved.reference.voxels(Occupancy::kOccupied));
  EXPECT_GT(loaded.reference.counts().occupied, loaded.mapped.counts().occupied);
}

TEST(Reference, MissingAndBrokenPartsAreRefusedByName) {
  for (const char* part : {"map.yaml", "map.pgm", "mapped.ot", "reference.ot"}) {
    const test::TemporaryFolder folder;
    save_reference(folder.path(), sample());
    const std::string whole = folder.read(part);
    std::filesystem::remove(folder.path() / part);
    const auto load = [&] { (void)load_reference(folder.path(), {}); };
    EXPECT_NE(test::sentence_of<InputError>(load).find(part), std::string::npos);
    folder.write(part, whole.substr(0, whole.size() / 2));
    EXPECT_NE(test::sentence_of<InputError>(load).find(part), std::string::npos);
    folder.write(part, std::string(whole.size(), '\0'));
    EXPECT_NE(test::sentence_of<InputError>(load).find(part), std::string::npos);
  }
}

}  // namespace
}  // namespace amiss::mission
