// The port of semantic segmentation (5.2.1): what each point of a reconstruction belongs to.
//
// in: cloud in the map frame [m], z up, the floor at z = 0; colours as long as the points (a forest and a network's
// votes want 1 cm reconstructions); normals as long as the points or empty     out: a class for each point, in the
// order of the cloud; kUnlabelled where a labeller cannot tell, and for points that are not finite
// Labellers are values that do not change: the same cloud gives the same classes, any number of threads may call.
// Errors: ArgumentError where colours or normals are not as long as the points.
#pragma once

#include <string>
#include <vector>

#include "core/frames.hpp"
#include "core/semantic_class.hpp"

namespace amiss::semantics {

/// For every report that shows something made of labels.
struct LabellerIdentity {
  std::string kind;      // forest, onnx or rendered
  std::string source;    // the model's file, or where the classes come from
  bool learned = false;  // false: the truth of a simulator, for ablations only

  /// "forest (share/semantics/forest.bin, learned)", "rendered (..., not learned)"
  [[nodiscard]] std::string to_line() const {
    return kind + " (" + source + (learned ? ", learned)" : ", not learned)");
  }
};

class SemanticLabeller {
 public:
  virtual ~SemanticLabeller() = default;

  [[nodiscard]] virtual LabellerIdentity identity() const = 0;
  [[nodiscard]] virtual std::vector<SemanticClass> label(const Cloud<Map>& cloud) const = 0;
};

}  // namespace amiss::semantics
