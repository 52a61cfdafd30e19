// The visuals of one body as few draw calls: shapes that share a texture and lie near each other become one batch, with
// colours in the vertices.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "world/world.hpp"

namespace amiss::sim::internal {

struct Vertex {
  std::array<float, 3> position;       // of the body's frame [m]
  std::array<std::int16_t, 4> normal;  // 32767 is 1; the last is a filler
  std::array<float, 2> uv;
  std::array<std::uint8_t, 4> colour;  // sRGB, alpha
  std::array<std::uint8_t, 4> matt;    // 255 * (1 - share that a shiny surface mirrors away), fillers
};

struct Batch {
  std::shared_ptr<const world::Texture> texture;  // or none
  bool transparent = false;
  bool closed = true;
  Eigen::AlignedBox3f box;  // of the body's frame
  std::uint32_t first_index = 0;
  std::uint32_t index_count = 0;
};

struct BodyMesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<Batch> batches;
};

[[nodiscard]] BodyMesh body_mesh(const world::Body& body);

}  // namespace amiss::sim::internal
