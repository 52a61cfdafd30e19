// The labeller that a command line asks for: a forest, a network with a recording, or the truth of a simulation.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "semantics/semantic_labeller.hpp"

namespace amiss::app {

struct LabelArguments {
  std::string cloud, out;
  std::string model;               // forest; the one that comes with amiss where none of these is given
  std::string network, recording;  // onnx: description of the network; what the cloud was made of
  std::string truth, confusion;    // rendered: cloud with the true classes in its field `label`; TSV
  std::vector<std::string> overrides;
  std::uint64_t seed = 1;
  int threads = 2;
};

/// ArgumentError where what is given does not go together.
[[nodiscard]] std::unique_ptr<semantics::SemanticLabeller> make_labeller(const LabelArguments& arguments);

/// Reads the cloud, labels it, writes it with a field `label` and says who did it.
void label_cloud(const LabelArguments& arguments);

/// The file that was chosen, or the forest that comes with amiss.
[[nodiscard]] std::string forest_file(const std::string& chosen);

}  // namespace amiss::app
