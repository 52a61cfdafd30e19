// Triangles made fit for drawing and physics.
#pragma once

#include <vector>

#include "world/mesh_file.hpp"

namespace amiss::world {

/// Takes out triangles that are not finite or have no area, gives unit normals to vertices without, and winds each
/// triangle so that its face looks where its vertices' normals look.
void mend_mesh(Mesh& mesh);

/// Parts that look the same become one; a part that is alone with its material stays the same mesh.
[[nodiscard]] std::vector<MeshPart> merged_by_material(const std::vector<MeshPart>& parts);

}  // namespace amiss::world
