// Labels of a 2D network, taken into the map by votes: each frame is labelled by the network, its pixels vote where
// they lie (class_votes.hpp), a point of the cloud takes the class with most votes around it.
// in: an ImageNetwork, then the frames of the recording that the cloud was made of, with their poses     out: a
// labeller of that cloud. Errors: as those of the network and of the votes.
#pragma once

#include "semantics/class_votes.hpp"
#include "semantics/image_network.hpp"
#include "semantics/semantic_labeller.hpp"

namespace amiss::semantics {

class OnnxLabeller final : public SemanticLabeller {
 public:
  explicit OnnxLabeller(ImageNetwork network, const VoteParams& votes = {})
      : network_(std::move(network)), votes_(votes) {}

  void look(const RgbdFrame& frame, const Transform<Map, Camera>& T_map_camera) {
    votes_.add(frame, network_.classes_of(frame), T_map_camera);
  }

  [[nodiscard]] LabellerIdentity identity() const override { return {"onnx", network_.name(), true}; }
  [[nodiscard]] std::vector<SemanticClass> label(const Cloud<Map>& cloud) const override;

 private:
  ImageNetwork network_;
  ClassVotes votes_;
};

}  // namespace amiss::semantics
