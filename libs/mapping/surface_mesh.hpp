// The surface of a TSDF as triangles and as points.
//
// in: SurfaceMap     out: TriangleMesh<Map> by marching cubes where the distance is 0, with colours and normals that
// point to where the camera was; Cloud<Map> with one point for each voxel that the surface passes: the mean of its
// vertices, colours and normals (5.3.2.2: "the centroid and average color of each voxel").
//
// A cube is used when all its corners were seen and weigh at least min_weight. Where the distance jumps from behind the
// surface to free space within a voxel, as it does behind the edges of things, there is no surface. Both are sorted by
// voxel and depend on nothing but the map's voxels.
#pragma once

#include "core/triangle_mesh.hpp"
#include "mapping/surface_map.hpp"

namespace amiss::mapping {

/// min_weight: of rays / depth^2 [1/m^2], as SurfaceVoxel::weight.
[[nodiscard]] TriangleMesh<Map> surface_mesh(const SurfaceMap& map, double min_weight = 0.0);
/// One point for each voxel that holds vertices of the mesh.
[[nodiscard]] Cloud<Map> surface_cloud(const TriangleMesh<Map>& mesh, double voxel_m);

}  // namespace amiss::mapping
