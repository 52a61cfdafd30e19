#include "sim/internal/body_mesh.hpp"

#include <gtest/gtest.h>

#include "sim/camera_fixture.hpp"
#include "sim/internal/closed_mesh.hpp"
#include "sim/internal/triangles.hpp"

namespace amiss::sim::internal {
namespace {

double volume(const Triangles& t) {
  double sum = 0.0;
  for (std::size_t i = 0; i < t.indices.size(); i += 3)
    sum += static_cast<double>(
        t.positions[t.indices[i]].dot(t.positions[t.indices[i + 1]].cross(t.positions[t.indices[i + 2]])));
  return sum / 6.0;
}

TEST(Triangles, PrimitivesAreClosedSolidsOfTheRightVolume) {
  const Triangles box = triangulate(world::Box{{1.0, 2.0, 3.0}});
  const Triangles cylinder = triangulate(world::Cylinder{0.5, 2.0});
  const Triangles sphere = triangulate(world::Sphere{0.5});
  for (const Triangles* t : {&box, &cylinder, &sphere}) EXPECT_TRUE(t->closed);
  EXPECT_TRUE(is_closed(box.positions, box.indices));
  EXPECT_NEAR(volume(box), 6.0, 1e-5);
  EXPECT_NEAR(volume(cylinder), std::numbers::pi / 2.0, 0.02);
  EXPECT_NEAR(volume(sphere), std::numbers::pi / 6.0, 0.01);
}

TEST(Triangles, NormalsPointOutwards) {
  for (const world::Geometry& geometry :
       {world::Geometry(world::Box{{1, 1, 1}}), world::Geometry(world::Cylinder{0.5, 1}),
        world::Geometry(world::Sphere{0.5})}) {
    const Triangles t = triangulate(geometry);
    for (std::size_t i = 0; i < t.positions.size(); ++i) {
      EXPECT_GT(t.normals[i].dot(t.positions[i]), 0.0F);
      EXPECT_NEAR(t.normals[i].norm(), 1.0F, 1e-5F);
    }
  }
}

TEST(ClosedMesh, HolesAndInsideOutSolidsAreNotClosed) {
  Triangles box = triangulate(world::Box{{1, 1, 1}});
  std::vector<std::uint32_t> turned = box.indices;
  for (std::size_t i = 0; i < turned.size(); i += 3) std::swap(turned[i], turned[i + 1]);
  EXPECT_FALSE(is_closed(box.positions, turned));
  box.indices.resize(box.indices.size() - 3);
  EXPECT_FALSE(is_closed(box.positions, box.indices));
  EXPECT_FALSE(is_closed({}, {}));
}

TEST(BodyMesh, NeighboursOfOneLookShareABatchAndTexturesAndGlassDoNot) {
  world::Body table = coloured_body("table", world::Box{{1, 1, 0.1}}, {0, 0, 0}, kRed);
  table.visuals.push_back(table.visuals[0]);
  table.visuals[1].material.diffuse = kBlue;
  EXPECT_EQ(body_mesh(table).batches.size(), 1U);
  table.visuals.push_back(table.visuals[0]);
  table.visuals[2].material.alpha = 0.5F;
  table.visuals.push_back(table.visuals[0]);
  table.visuals[3].material.texture = std::make_shared<world::Texture>(world::Texture{1, 1, {Rgb{}}});
  table.visuals.push_back(table.visuals[0]);
  table.visuals[4].T_body_shape.translation().x() = 30.0;
  const BodyMesh mesh = body_mesh(table);
  EXPECT_EQ(mesh.batches.size(), 4U);
  std::uint32_t indices = 0;
  for (const Batch& batch : mesh.batches) {
    EXPECT_EQ(batch.first_index, indices);
    indices += batch.index_count;
  }
  EXPECT_EQ(indices, mesh.indices.size());
  EXPECT_EQ(indices, 5U * 36U);
}

}  // namespace
}  // namespace amiss::sim::internal
