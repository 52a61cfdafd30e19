// Clusters of what stands on the ground: smooth pieces of one colour first, then pieces that belong together.
#pragma once

#include "segment/internal/window.hpp"

namespace amiss::segment::internal {

struct Piece {
  std::vector<std::uint32_t> members;  // indices of the window, ascending
  double contact_m = 0.0;              // length along which it continues outside of the crop
  bool at_image_border = false;
};

/// What the crop holds above the ground.
struct Relief {
  std::vector<float> height_m;           // above the ground, from the smoothed points
  std::vector<Eigen::Vector3f> normals;  // zero where none
  std::vector<bool> standing;            // inside of the crop and clearly above the ground
};
[[nodiscard]] Relief relief_of(const Window& window, const Plane& ground, const Params& params);

/// Region growing over neighbouring pixels by proximity, smoothness and colour (Section 4.2.7).
[[nodiscard]] std::vector<Piece> pieces_of(const Window& window, const Relief& relief, const Params& params);

/// Pieces whose footprints are less than gap_m apart are one cluster.
[[nodiscard]] std::vector<Piece> joined(const std::vector<Piece>& pieces, const Window& window, const Params& params);

}  // namespace amiss::segment::internal
