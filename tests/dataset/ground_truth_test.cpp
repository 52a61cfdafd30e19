#include "dataset/ground_truth.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "dataset/tum_writer.hpp"

namespace amiss::dataset {
namespace {

TEST(GroundTruthTest, PointsOfARecordingGetTheirBodiesObjectsAndClasses) {
  const auto folder = std::filesystem::temp_directory_path() / ("amiss_truth_" + std::to_string(getpid()));
  PosedFrame posed;
  posed.frame.stamp = Stamp(std::chrono::seconds(1));
  posed.frame.intrinsics = {40, 30, 40.0, 40.0, 19.5, 14.5};
  posed.frame.depth_m.assign(1200, 1.0F);
  posed.frame.colour.assign(1200, {100, 100, 100});
  std::vector<std::uint16_t> numbers(1200, 2);
  for (std::size_t i = 0; i < numbers.size(); i += 40) numbers[i] = 5;  // the leftmost column is a mug
  TumWriter writer(folder, {posed.frame.intrinsics, 1000.0});
  writer.add(posed);
  writer.finish();
  InstanceWriter instances(folder / "truth");
  instances.add(posed.frame.stamp, 40, 30, numbers);
  instances.finish();
  save_instances(folder / "truth" / "instances.tsv", {{2, "wall_1", "", SemanticClass::kWall, false},
                                            {5, "mug", "mug", SemanticClass::kOtherProp, true},
                                            {6, "bowl", "bowl", SemanticClass::kOtherProp, false}});

  Cloud<Map> cloud;
  cloud.points = {{0.0F, 0.0F, 1.0F}, {-0.4875F, 0.0F, 1.0F}, {0.0F, 0.0F, 3.0F}, {-0.4875F, 0.1F, 1.0F}};
  const GroundTruth truth = ground_truth_of(cloud, folder, 1);
  EXPECT_EQ(truth.of_point, (std::vector<std::uint16_t>{2, 5, 0, 5}));
  const auto objects = truth.objects();
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].name, "mug");
  EXPECT_EQ(objects[0].points, (std::vector<std::uint32_t>{1, 3}));
  EXPECT_EQ(objects[0].on_floor, true);
  EXPECT_EQ(truth.placed(), (std::vector<std::string>{"mug", "bowl"}));
  EXPECT_EQ(truth.seen(), 3U);
  const CloudFile labelled = truth.labelled(cloud);
  EXPECT_EQ(labelled.field("label")->values, (std::vector<double>{1, 40, 0, 40}));
  EXPECT_EQ(labelled.field("instance")->values, (std::vector<double>{2, 5, 0, 5}));

  std::ofstream(folder / "truth" / "instances.txt") << "# timestamp filename\n";
  EXPECT_NE(test::sentence_of<InputError>([&] {
              static_cast<void>(ground_truth_of(cloud, folder));
            }).find("instances.txt: lists 0 images and none for the frame of 1.000000000 s"),
            std::string::npos);
  std::filesystem::remove(folder / "truth" / "instances.tsv");
  EXPECT_THROW(static_cast<void>(ground_truth_of(cloud, folder)), InputError);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace amiss::dataset
