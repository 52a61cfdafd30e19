#include "dataset/full_room.hpp"

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "core/temporary_folder.hpp"

namespace amiss::dataset {
namespace {

TEST(FullRoom, ScenesAreWrittenAsObChangeHasThem) {
  const test::TemporaryFolder folder;
  CloudFile cloud;
  cloud.mesh.vertices.points = {{0.0F, 0.0F, 1.0F}, {0.5F, 0.0F, 1.0F}, {1.0F, 0.0F, 1.0F}};
  GroundTruth truth;
  truth.instances = {{3, "wall", "", SemanticClass::kWall, false}};
  truth.of_point = {3, 3, 0};
  save_scene(folder.path() / "big_room", "scene1", cloud, truth);
  truth.instances.push_back({9, "mug", "mug", SemanticClass::kOtherProp, true});
  truth.of_point = {3, 9, 9};
  save_scene(folder.path() / "big_room", "scene2", cloud, truth);

  const auto annotations = folder.path() / "big_room" / "Annotations";
  EXPECT_FALSE(std::filesystem::exists(annotations / "scene1_GT.anno")) << "nothing was placed";
  EXPECT_EQ(load_bytes(annotations / "scene2_GT.anno"), "mug 1 2 true\n");
  const CloudFile scene = load_cloud(folder.path() / "big_room" / "scene2.pcd");
  EXPECT_EQ(scene.cloud().points, cloud.cloud().points);
  EXPECT_TRUE(scene.fields.empty()) << "the truth stands apart";
  EXPECT_EQ(load_cloud(annotations / "scene2_labels.pcd").field("label")->values, (std::vector<double>{1, 40, 40}));
  EXPECT_EQ(load_cloud(annotations / "scene2_labels.pcd").field("instance")->values, (std::vector<double>{3, 9, 9}));
}

}  // namespace
}  // namespace amiss::dataset
