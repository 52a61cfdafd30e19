// A network of the user's that gives every pixel of a colour image a class: ONNX, run by OpenCV's dnn on the processor.
// in: a description (YAML) beside the network:
//   network: segmentation.onnx                       # beside the description
//   input: [320, 240]                                # width, height [px] that images are scaled to
//   mean: [0.485, 0.456, 0.406]                      # of red, green, blue in 0 .. 1, taken off ...
//   deviation: [0.229, 0.224, 0.225]                 # ... before it is divided by this; (0 0 0) and (1 1 1) if left
//   out classes: [wall, floor, unlabelled, table]        # of the output's channels; ScanNet's names
// The network takes 1 x 3 x height x width and gives 1 x classes x h x w scores: a pixel gets the class of the highest.
// out: a class for each pixel of the image. Errors: InputError that names file and line, what is wrong and what is
// allowed; it is tried on an empty image when it is loaded, so that a network that cannot be run is told of then.
// Threads: one call at a time.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/semantic_class.hpp"
#include "core/sensors.hpp"

namespace amiss::semantics {

struct NetworkInput {
  int width_px = 320, height_px = 240;
  std::vector<double> mean = {0, 0, 0}, deviation = {1, 1, 1};
};

class ImageNetwork {
 public:
  /// `name` is what errors and reports call it.
  ImageNetwork(std::string_view onnx_bytes, NetworkInput input, std::vector<SemanticClass> classes, std::string name);
  ~ImageNetwork();
  ImageNetwork(ImageNetwork&&) noexcept;
  ImageNetwork& operator=(ImageNetwork&&) noexcept;

  [[nodiscard]] std::vector<SemanticClass> classes_of(const RgbdFrame& frame);
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  struct State;
  std::unique_ptr<State> state_;
  std::string name_;
};

[[nodiscard]] ImageNetwork load_image_network(const std::filesystem::path& description);

}  // namespace amiss::semantics
