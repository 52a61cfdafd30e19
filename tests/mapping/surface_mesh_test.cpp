#include "mapping/surface_mesh.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "mapping/internal/marching_cubes.hpp"
#include "mapping/surface_scene.hpp"

namespace amiss::mapping {
namespace {

const Transform<Map, Camera> kAhead = camera_pose(0, 0, 0, 0, 0);

SurfaceMap map_of(const SurfaceRecording& r, double voxel_m) {
  SurfaceParams params;
  params.voxel_m = voxel_m;
  SurfaceMap map(params);
  for (std::size_t i = 0; i < r.frames.size(); ++i) map.insert(r.frames[i], r.poses[i]);
  return map;
}

TEST(MarchingCubes, EdgesJoinNeighbours) {
  std::set<std::pair<int, int>> all;
  for (int e = 0; e < kCubeEdges; ++e) {
    const CubeEdge edge = cube_edge(e);
    EXPECT_EQ(edge.corner & (1 << edge.axis), 0);
    all.insert({edge.corner, edge.axis});
  }
  EXPECT_EQ(all.size(), 12U);
}

TEST(MarchingCubes, TrianglesLieOnCutEdgesAndUseThemAll) {
  for (unsigned pattern = 0; pattern < 256; ++pattern) {
    std::set<int> used, cut;
    for (const auto& triangle : cube_triangles(pattern)) used.insert(triangle.begin(), triangle.end());
    for (int e = 0; e < kCubeEdges; ++e) {
      const CubeEdge edge = cube_edge(e);
      if (((pattern >> edge.corner) & 1U) != ((pattern >> (edge.corner | (1 << edge.axis))) & 1U)) cut.insert(e);
    }
    EXPECT_EQ(used, cut) << pattern;
  }
  EXPECT_EQ(cube_triangles(1).size(), 1U);
  EXPECT_EQ(cube_triangles(0b00001111).size(), 2U);
}

/// Whatever lies inside, its skin is closed: each side of a triangle is met by another one, the other way round; and it
/// looks outward: the volume within is positive.
RC_GTEST_PROP(MarchingCubes, SkinsAreClosed, ()) {
  constexpr int kEdge = 5;
  const auto bits = *rc::gen::container<std::vector<bool>>(kEdge * kEdge * kEdge, rc::gen::arbitrary<bool>());
  const auto inside = [&](int x, int y, int z) {
    const bool border = x <= 0 || y <= 0 || z <= 0 || x > kEdge || y > kEdge || z > kEdge;
    return !border && bits[static_cast<std::size_t>(((z - 1) * kEdge + y - 1) * kEdge + x - 1)];
  };
  using Vertex = std::array<int, 3>;  // in half steps
  std::map<std::pair<Vertex, Vertex>, int> sides;
  double six_volumes = 0.0;
  for (int z = 0; z <= kEdge; ++z) {
    for (int y = 0; y <= kEdge; ++y) {
      for (int x = 0; x <= kEdge; ++x) {
        unsigned pattern = 0;
        for (int c = 0; c < 8; ++c) {
          pattern |= (inside(x + (c & 1), y + ((c >> 1) & 1), z + (c >> 2)) ? 1U : 0U) << c;
        }
        for (const auto& triangle : cube_triangles(pattern)) {
          Eigen::Matrix3d p;
          std::array<Vertex, 3> vertices;
          for (std::size_t i = 0; i < 3; ++i) {
            const CubeEdge e = cube_edge(triangle[i]);
            vertices[i] = {2 * (x + (e.corner & 1)), 2 * (y + ((e.corner >> 1) & 1)), 2 * (z + (e.corner >> 2))};
            vertices[i][static_cast<std::size_t>(e.axis)] += 1;
            p.row(static_cast<Eigen::Index>(i)) = Eigen::RowVector3d(vertices[i][0], vertices[i][1], vertices[i][2]);
          }
          six_volumes += p.determinant();
          for (std::size_t i = 0; i < 3; ++i) {
            ++sides[{vertices[i], vertices[(i + 1) % 3]}];
            --sides[{vertices[(i + 1) % 3], vertices[i]}];
          }
        }
      }
    }
  }
  for (const auto& [side, unmet] : sides) RC_ASSERT(unmet == 0);
  RC_ASSERT(six_volumes >= 0.0);
}

TEST(SurfaceMesh, AWallIsFlatAndLooksAtTheCamera) {
  SurfaceMap map;
  map.insert(wall_frame(1.2f, {200, 100, 50}), kAhead);
  const TriangleMesh<Map> mesh = surface_mesh(map);
  ASSERT_GT(mesh.triangles.size(), 10000U);
  ASSERT_EQ(mesh.vertices.colours.size(), mesh.vertices.points.size());
  ASSERT_EQ(mesh.vertices.normals.size(), mesh.vertices.points.size());
  std::size_t coloured = 0;
  for (std::size_t i = 0; i < mesh.vertices.points.size(); ++i) {
    ASSERT_NEAR(mesh.vertices.points[i].x(), 1.2f, 1e-4f);
    ASSERT_LT(mesh.vertices.normals[i].x(), -0.99f);
    coloured += mesh.vertices.colours[i] == Rgb{200, 100, 50} ? 1U : 0U;
  }
  EXPECT_EQ(coloured, mesh.vertices.points.size());
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t i : t) ASSERT_LT(i, mesh.vertices.points.size());
  }
}

TEST(SurfaceMesh, LiesOnTheSurfaceAndNowhereElse) {
  const SurfaceMap map = map_of(surface_recording(3, false, CameraIntrinsics{}), 0.02);
  const TriangleMesh<Map> mesh = surface_mesh(map);
  ASSERT_GT(mesh.vertices.points.size(), 10000U);
  const TestScene scene = surface_scene();
  double squares = 0.0;
  std::size_t far = 0;
  for (const Eigen::Vector3f& p : mesh.vertices.points) {
    const double off = std::abs(distance_to(scene, p.cast<double>()));
    squares += off * off;
    far += off > 0.01 ? 1U : 0U;
  }
  const auto n = static_cast<double>(mesh.vertices.points.size());
  EXPECT_LT(std::sqrt(squares / n), 0.002) << "a tenth of a voxel";
  EXPECT_LT(static_cast<double>(far), 0.002 * n) << "no skirts from edges of things into their shadow";
}

TEST(SurfaceMesh, LeavesOutWhatWeighsLittle) {
  SurfaceMap map;
  map.insert(wall_frame(1.2f, {200, 100, 50}), kAhead);
  const double weight = static_cast<double>(map.voxel(map.voxel_at({1.205, 0, 0}))->weight);
  EXPECT_FALSE(surface_mesh(map, 0.8 * weight).triangles.empty());
  EXPECT_TRUE(surface_mesh(map, 1.5 * weight).triangles.empty());
}

TEST(SurfaceMesh, DoesNotDependOnTheOrderOfTheBlocks) {
  const auto behind = camera_pose(0, 0, 3.0, 0, 0);
  SurfaceMap a, b;
  a.insert(wall_frame(1.2f, {200, 100, 50}), kAhead);
  a.insert(wall_frame(0.9f, {20, 10, 150}), behind);
  b.insert(wall_frame(0.9f, {20, 10, 150}), behind);
  b.insert(wall_frame(1.2f, {200, 100, 50}), kAhead);
  ASSERT_NE(a.values().blocks().front().key, b.values().blocks().front().key);
  const TriangleMesh<Map> x = surface_mesh(a), y = surface_mesh(b);
  EXPECT_TRUE(x.vertices.points == y.vertices.points);
  EXPECT_TRUE(x.vertices.colours == y.vertices.colours);
  EXPECT_TRUE(x.triangles == y.triangles);
}

TEST(SurfaceMesh, OfNothingIsEmpty) {
  EXPECT_TRUE(surface_mesh(SurfaceMap()).triangles.empty());
  EXPECT_TRUE(surface_cloud({}, 0.01).points.empty());
}

TEST(SurfaceCloud, HasOnePointForEachVoxel) {
  const SurfaceMap map = map_of(surface_recording(2, true, small_camera()), 0.04);
  const TriangleMesh<Map> mesh = surface_mesh(map);
  const Cloud<Map> cloud = surface_cloud(mesh, 0.04);
  ASSERT_GT(cloud.points.size(), 500U);
  ASSERT_EQ(cloud.colours.size(), cloud.points.size());
  ASSERT_EQ(cloud.normals.size(), cloud.points.size());
  std::set<Voxel> of_mesh;
  for (const Eigen::Vector3f& p : mesh.vertices.points) of_mesh.insert(map.voxel_at(p.cast<double>()));
  std::vector<Voxel> of_cloud;
  for (const Eigen::Vector3f& p : cloud.points) of_cloud.push_back(map.voxel_at(p.cast<double>()));
  EXPECT_EQ(of_cloud.size(), of_mesh.size());
  EXPECT_TRUE(std::is_sorted(of_cloud.begin(), of_cloud.end()));
}

TEST(SurfaceCloud, TakesTheMeans) {
  TriangleMesh<Map> mesh;
  mesh.vertices.points = {{0.002f, 0.002f, 0.002f}, {0.004f, 0.006f, 0.002f}, {-0.002f, 0.001f, 0.001f}};
  mesh.vertices.colours = {{10, 20, 30}, {20, 40, 61}, {1, 2, 3}};
  mesh.vertices.normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Cloud<Map> cloud = surface_cloud(mesh, 0.01);
  ASSERT_EQ(cloud.points.size(), 2U);
  EXPECT_TRUE(cloud.points[0].isApprox(Eigen::Vector3f(-0.002f, 0.001f, 0.001f)));
  EXPECT_TRUE(cloud.points[1].isApprox(Eigen::Vector3f(0.003f, 0.004f, 0.002f)));
  EXPECT_EQ(cloud.colours[1], (Rgb{15, 30, 46}));
  EXPECT_TRUE(cloud.normals[1].isApprox(Eigen::Vector3f(1, 1, 0).normalized()));
}

}  // namespace
}  // namespace amiss::mapping
