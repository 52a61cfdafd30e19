#include "semantics_label.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "core/result.hpp"
#include "dataset/cloud_files.hpp"
#include "reconstruct_recording.hpp"
#include "resources.hpp"
#include "semantics/forest_labeller.hpp"
#include "semantics/onnx_labeller.hpp"
#include "semantics/rendered_labeller.hpp"

namespace amiss::app {

namespace {

constexpr std::string_view kLabelsNote = "amiss labels: ";

bool tells_labeller(const std::string& note) { return note.starts_with(kLabelsNote); }

std::unique_ptr<semantics::SemanticLabeller> of_network(const LabelArguments& arguments) {
  auto labeller = std::make_unique<semantics::OnnxLabeller>(semantics::load_image_network(arguments.network));
  dataset::RecordingOptions options;
  options.intrinsics = intrinsics_of(arguments.intrinsics);
  if (arguments.depth_scale != 0.0) options.depth_scale = arguments.depth_scale;
  const auto recording = open_any_recording(arguments.recording, options);
  for (std::size_t i = 0; i < recording->size(); ++i) {
    const dataset::PosedFrame posed = recording->load(i);
    labeller->look(posed.frame, posed.T_map_camera);
  }
  return labeller;
}

semantics::RenderedLabeller::Truth load_truth(const std::string& file) {
  dataset::CloudFile cloud = dataset::load_cloud(file);
  const dataset::ScalarField* const field = cloud.field("label");
  if (field == nullptr) throw InputError(file + ": no field `label`; the true class of each point (NYU40) is needed");
  semantics::RenderedLabeller::Truth truth{cloud.cloud().points, {}};
  for (const double value : field->values) {
    SemanticClass known = SemanticClass::kUnlabelled;
    for (const NamedSemanticClass& c : kSemanticClasses) {
      if (static_cast<double>(c.value) == value) known = c.value;
    }
    truth.classes.push_back(known);
  }
  return truth;
}

}  // namespace

std::string told_labeller(const dataset::CloudFile& cloud) {
  const auto told = std::find_if(cloud.notes.begin(), cloud.notes.end(), tells_labeller);
  return told == cloud.notes.end() ? "" : told->substr(kLabelsNote.size());
}

std::string forest_file(const std::string& chosen) {
  return chosen.empty() ? (find_resources().objects.parent_path() / "semantics" / "forest.bin").string() : chosen;
}

std::unique_ptr<semantics::SemanticLabeller> make_labeller(const LabelArguments& arguments) {
  const int chosen = !arguments.model.empty() + !arguments.network.empty() + !arguments.truth.empty();
  if (chosen > 1) throw ArgumentError("one of --model, --network and --truth is allowed");
  if (arguments.network.empty() != arguments.recording.empty()) {
    throw ArgumentError("--network and --recording belong together: a network looks at the recording's images");
  }
  if (arguments.recording.empty() && (!arguments.intrinsics.empty() || arguments.depth_scale != 0.0)) {
    throw ArgumentError("--intrinsics and --depth-scale are of the --recording");
  }
  if (!arguments.confusion.empty() && arguments.truth.empty()) throw ArgumentError("--confusion needs --truth");
  semantics::ForestLabellerParams forest;
  semantics::SpoilParams spoil;
  ParamTable table;
  semantics::describe(table, forest);
  semantics::describe(table, spoil);
  forest.threads = arguments.threads;
  for (const std::string& assignment : arguments.overrides) table.set_override(assignment);
  if (!arguments.network.empty()) return of_network(arguments);
  if (!arguments.truth.empty()) {
    const auto confusion =
        arguments.confusion.empty() ? semantics::Confusion() : semantics::load_confusion(arguments.confusion);
    return std::make_unique<semantics::RenderedLabeller>(load_truth(arguments.truth), confusion, spoil, arguments.seed);
  }
  return std::make_unique<semantics::ForestLabeller>(
      semantics::load_forest_labeller(forest_file(arguments.model), forest));
}

void label_cloud(const LabelArguments& arguments) {
  dataset::CloudFile cloud = dataset::load_cloud(arguments.cloud);
  const auto labeller = make_labeller(arguments);
  const std::vector<SemanticClass> classes = labeller->label(cloud.cloud());
  std::erase_if(cloud.fields, [](const dataset::ScalarField& field) { return field.name == "label"; });
  dataset::ScalarField& field = cloud.fields.emplace_back();
  field.name = "label";
  for (const SemanticClass value : classes) field.values.push_back(static_cast<double>(value));
  std::erase_if(cloud.notes, tells_labeller);
  cloud.notes.push_back(std::string(kLabelsNote) + labeller->identity().to_line());
  dataset::save_cloud(arguments.out, cloud);
  std::cerr << fmt::format("amiss: {} points labelled by {}\n", classes.size(), labeller->identity().to_line());
}

}  // namespace amiss::app
