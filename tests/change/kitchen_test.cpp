// A real kitchen (7-Scenes) from its images to what is new in it: reconstructed at 1 cm with rays of 2 m, then held
// against its reference. Skipped where the recording is not there.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "change/novel.hpp"
#include "dataset/recording.hpp"
#include "mapping/reconstructor.hpp"
#include "mapping/test_data.hpp"

namespace amiss::change {
namespace {

namespace fs = std::filesystem;

fs::path kitchen() { return mapping::test_data() / "rgbd_redkitchen"; }

Scene reconstructed(const std::string& visit) {
  dataset::RecordingOptions options;
  options.intrinsics = CameraIntrinsics{0, 0, 585.0, 585.0, 320.0, 240.0};
  const auto recording = dataset::open_recording(kitchen() / visit, options);
  const auto reconstructor = mapping::make_reconstructor({});
  for (std::size_t i = 0; i < recording->size(); ++i) {
    const dataset::PosedFrame posed = recording->load(i);
    reconstructor->insert(posed.frame, posed.T_map_camera);
  }
  mapping::Reconstruction made = reconstructor->finish();
  Scene scene;
  scene.cloud = std::move(made.cloud);
  scene.space = std::move(made.space);
  return scene;
}

Eigen::Vector3d vector_of(const nlohmann::json& json) {
  return Eigen::Vector3d(json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>());
}

TEST(Kitchen, NothingIsNewWhereNothingChangedAndSixObjectsAreFound) {
  if (!fs::exists(kitchen())) GTEST_SKIP() << "rgbd_redkitchen is not there";
  const Scene reference = reconstructed("reference");
  EXPECT_TRUE(detect_novel(reference, reconstructed("nochange"), "local-verification").objects.empty());

  const auto truth = nlohmann::json::parse(std::ifstream(kitchen() / "ground_truth_dev.json"))["visits"]["dev_visit1"];
  const Detection found = detect_novel(reference, reconstructed("dev_visit1"), "local-verification");
  ASSERT_EQ(truth["objects"].size(), 6U);
  std::vector<bool> right(found.objects.size(), false);
  for (const auto& object : truth["objects"]) {
    constexpr double kMargin_m = 0.01;
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kMargin_m);
    const Eigen::AlignedBox3d box(vector_of(object["aabb_min"]) - margin, vector_of(object["aabb_max"]) + margin);
    int times = 0;
    for (std::size_t k = 0; k < found.objects.size(); ++k) {
      if (!box.contains(0.5 * (found.objects[k].low_m + found.objects[k].high_m))) continue;
      right[k] = true;
      ++times;
    }
    EXPECT_GE(times, 1) << object["name"];
  }
  for (std::size_t k = 0; k < right.size(); ++k) EXPECT_TRUE(right[k]) << found.objects[k].low_m.transpose();
}

}  // namespace
}  // namespace amiss::change
