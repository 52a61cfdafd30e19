#include "video/section.hpp"

#include <gtest/gtest.h>

#include "world/bounds.hpp"

namespace amiss::video {
namespace {

world::Body body_of(const world::Geometry& geometry, double z_m) {
  world::Body body;
  body.pose.T.translate(Eigen::Vector3d(3.0, 2.0, z_m));
  body.visuals.push_back({geometry, Eigen::Isometry3d::Identity(), {}});
  return body;
}

Eigen::AlignedBox3d bounds_of(const world::Body& body) { return world::bounds_in_world(body); }

/// A box as the triangles of a mesh, 2.5 m high.
std::shared_ptr<world::Mesh> wall_mesh() {
  auto mesh = std::make_shared<world::Mesh>();
  const Eigen::Vector3f low(0, 0, 0), high(4.0F, 0.1F, 2.5F);
  for (unsigned i = 0; i < 8; ++i) {
    mesh->vertices.emplace_back((i & 1U) != 0 ? high.x() : low.x(), (i & 2U) != 0 ? high.y() : low.y(),
                                (i & 4U) != 0 ? high.z() : low.z());
    mesh->normals.push_back((mesh->vertices.back() - 0.5F * (low + high)).normalized());
  }
  mesh->indices = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                   2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  return mesh;
}

TEST(Section, ShortensWhatIsTall) {
  const auto wall = cut_open(body_of(world::Box{{4.0, 0.1, 2.5}}, 1.25));
  EXPECT_NEAR(bounds_of(wall).min().z(), 0.0, 1e-9);
  EXPECT_NEAR(bounds_of(wall).max().z(), 1.0, 1e-9);
  const auto column = cut_open(body_of(world::Cylinder{0.2, 2.5}, 1.25), {2.0, 0.6});
  EXPECT_NEAR(bounds_of(column).max().z(), 0.6, 1e-9);
}

TEST(Section, LeavesFurnitureAndTakesTheCeiling) {
  const auto shelf = cut_open(body_of(world::Box{{1.0, 0.4, 1.9}}, 0.95));
  EXPECT_NEAR(bounds_of(shelf).max().z(), 1.9, 1e-9);
  EXPECT_TRUE(cut_open(body_of(world::Box{{4.0, 4.0, 0.1}}, 2.55)).visuals.empty());
}

TEST(Section, CutsMeshesAndLinesThem) {
  const auto wall = cut_open(body_of(world::MeshInstance{wall_mesh(), {1.0, 2.0, 1.0}}, 0.0));
  ASSERT_EQ(wall.visuals.size(), 2U) << "what is left, and its dark lining";
  world::Body surface = wall;
  surface.visuals.erase(surface.visuals.begin());
  const Eigen::AlignedBox3d box = bounds_of(surface);
  EXPECT_LT(bounds_of(wall).max().z(), 1.004) << "the lining lies behind the surface";
  EXPECT_NEAR(box.max().z(), 1.0, 1e-5);
  EXPECT_NEAR(box.sizes().x(), 4.0, 1e-5);
  EXPECT_NEAR(box.sizes().y(), 0.2, 1e-5);
  double area_m2 = 0.0;  // of the sides and the floor, no cover
  const auto& mesh = *std::get<world::MeshInstance>(wall.visuals[1].geometry).mesh;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) -> Eigen::Vector3f {
      return mesh.vertices[mesh.indices[i + k]].cwiseProduct(Eigen::Vector3f(1.0F, 2.0F, 1.0F));
    };
    area_m2 += 0.5 * static_cast<double>((at(1) - at(0)).cross(at(2) - at(0)).norm());
  }
  EXPECT_NEAR(area_m2, 2 * (4.0 * 1.0 + 0.2 * 1.0) + 4.0 * 0.2, 1e-4);
}

}  // namespace
}  // namespace amiss::video
