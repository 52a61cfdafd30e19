// A real kitchen (7-Scenes) from its images to what is new in it: reconstructed at 1 cm with rays of 2 m, then held
// against its reference. Skipped where the recording is not there.
#include <gtest/gtest.h>

#include <algorithm>
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

struct Found {
  int objects = 0, found = 0, wrong = 0;
};

/// How many objects of the visit have a cluster in their box, and how many clusters are in no object's box.
Found held_against_truth(const Detection& detection, const std::string& visit) {
  const auto truth = nlohmann::json::parse(std::ifstream(kitchen() / "ground_truth_dev.json"))["visits"][visit];
  Found out;
  std::vector<bool> right(detection.objects.size(), false);
  for (const auto& object : truth["objects"]) {
    constexpr double kMargin_m = 0.01;
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kMargin_m);
    const Eigen::AlignedBox3d box(vector_of(object["aabb_min"]) - margin, vector_of(object["aabb_max"]) + margin);
    bool found = false;
    for (std::size_t k = 0; k < detection.objects.size(); ++k) {
      if (!box.contains(0.5 * (detection.objects[k].low_m + detection.objects[k].high_m))) continue;
      right[k] = found = true;
    }
    ++out.objects;
    out.found += found ? 1 : 0;
  }
  out.wrong = static_cast<int>(std::count(right.begin(), right.end(), false));
  return out;
}

TEST(Kitchen, NothingIsNewWhereNothingChangedAndWhatIsNewIsFound) {
  if (!fs::exists(kitchen())) GTEST_SKIP() << "rgbd_redkitchen is not there";
  Scene reference = reconstructed("reference");
  const Scene nochange = reconstructed("nochange");
  EXPECT_TRUE(detect_novel(reference, nochange, "local-verification").objects.empty());

  const Scene first_visit = reconstructed("dev_visit1");
  const Found first = held_against_truth(detect_novel(reference, first_visit, "local-verification"), "dev_visit1");
  EXPECT_EQ(first.objects, 6);
  EXPECT_EQ(first.found, 6);
  EXPECT_EQ(first.wrong, 0);
  const Found second =
      held_against_truth(detect_novel(reference, reconstructed("dev_visit2"), "local-verification"), "dev_visit2");
  EXPECT_EQ(second.objects, 7);
  EXPECT_GE(second.found, 6);
  EXPECT_LE(second.wrong, 1);

  reference.space.reset();  // as of clouds that others made
  EXPECT_LE(detect_novel(reference, nochange, "local-verification").objects.size(), 1U);
  EXPECT_EQ(held_against_truth(detect_novel(reference, first_visit, "local-verification"), "dev_visit1").found, 6);
}

}  // namespace
}  // namespace amiss::change
