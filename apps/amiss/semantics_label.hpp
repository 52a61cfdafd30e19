// The labeller that a command line asks for: a forest, a network with a recording, or the truth of a simulation.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "dataset/cloud_files.hpp"
#include "semantics/semantic_labeller.hpp"

namespace amiss::app {

struct LabelArguments {
  std::string cloud, out;
  std::string model;               // forest; the one that comes with amiss where none of these is given
  std::string network, recording;  // onnx: description of the network; what the cloud was made of
  std::vector<double> intrinsics;  // of the recording's camera, where it does not say them
  double depth_scale = 0.0;        // 0: the recording's
  std::string truth, confusion;    // rendered: cloud with the true classes in its field `label`; TSV
  std::vector<std::string> overrides;
  std::uint64_t seed = 1;
  int threads = 2;
};

/// ArgumentError where what is given does not go together.
[[nodiscard]] std::unique_ptr<semantics::SemanticLabeller> make_labeller(const LabelArguments& arguments);

/// Reads the cloud, labels it, writes it with a field `label` and says who did it.
void label_cloud(const LabelArguments& arguments);

/// Who gave a cloud its field `label`, as `amiss semantics label` left it in the file ("amiss labels: ..." among the
/// cloud's notes); empty where nobody did.
[[nodiscard]] std::string told_labeller(const dataset::CloudFile& cloud);

/// The file that was chosen, or the forest that comes with amiss.
[[nodiscard]] std::string forest_file(const std::string& chosen);

}  // namespace amiss::app
