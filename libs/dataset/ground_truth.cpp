#include "dataset/ground_truth.hpp"

#include <algorithm>

#include "core/result.hpp"
#include "dataset/instance_votes.hpp"
#include "dataset/internal/text.hpp"

namespace amiss::dataset {

std::vector<std::string> GroundTruth::placed() const {
  std::vector<std::string> names;
  for (const Instance& instance : instances) {
    if (!instance.kind.empty()) names.push_back(instance.name);
  }
  return names;
}

std::size_t GroundTruth::seen() const {
  return of_point.size() - static_cast<std::size_t>(std::count(of_point.begin(), of_point.end(), 0));
}

std::vector<AnnotatedObject> GroundTruth::objects() const {
  std::vector<AnnotatedObject> objects;
  for (const Instance& instance : instances) {
    if (instance.kind.empty()) continue;
    AnnotatedObject object{instance.name, {}, instance.on_floor};
    for (std::size_t i = 0; i < of_point.size(); ++i) {
      if (of_point[i] == instance.number) object.points.push_back(static_cast<std::uint32_t>(i));
    }
    if (!object.points.empty()) objects.push_back(std::move(object));
  }
  return objects;
}

CloudFile GroundTruth::labelled(const Cloud<Map>& cloud) const {
  CloudFile file;
  file.mesh.vertices = cloud;
  ScalarField label{"label", {}}, number{"instance", {}};
  for (const std::uint16_t one : of_point) {
    const auto found = std::find_if(instances.begin(), instances.end(), [&](const auto& i) { return i.number == one; });
    label.values.push_back(found == instances.end() ? 0.0 : static_cast<double>(found->value));
    number.values.push_back(static_cast<double>(one));
  }
  file.fields = {std::move(label), std::move(number)};
  return file;
}

GroundTruth ground_truth_of(const Cloud<Map>& cloud, const std::filesystem::path& recording, std::size_t every,
                            const std::filesystem::path& poses) {
  GroundTruth truth;
  truth.instances = load_instances(recording / "truth" / "instances.tsv");
  const InstanceImages images(recording / "truth");
  RecordingOptions options;
  options.poses = poses;
  const auto frames = open_recording(recording, options);
  InstanceVotes votes(cloud.points);
  for (std::size_t i = 0; i < frames->size(); i += std::max<std::size_t>(1, every)) {
    const PosedFrame frame = frames->load(i);
    const auto numbers = images.load(frame.frame.stamp);
    if (!numbers) {
      throw InputError((recording / "truth" / "instances.txt").string() + ": lists " + std::to_string(images.size()) +
                       " images and none for the frame of " + text_of(frame.frame.stamp) +
                       " s; one for each of the recording's frames is needed");
    }
    votes.add(frame, *numbers);
  }
  truth.of_point = votes.numbers();
  return truth;
}

}  // namespace amiss::dataset
