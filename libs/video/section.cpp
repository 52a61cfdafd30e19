#include "video/section.hpp"

#include <algorithm>
#include <array>

#include "world/bounds.hpp"

namespace amiss::video {

namespace {

constexpr float kLining_m = 0.004F;  // how far behind its surface the lining lies
const Eigen::Vector3f kDark(0.13F, 0.14F, 0.16F);

struct Corner {
  Eigen::Vector3f position, normal;
  Eigen::Vector2f uv;
  Rgb colour;
};

Corner between(const Corner& a, const Corner& b, float part) {
  const auto mix = [part](std::uint8_t x, std::uint8_t y) {
    return static_cast<std::uint8_t>(std::lround(std::lerp(static_cast<float>(x), static_cast<float>(y), part)));
  };
  return {a.position + part * (b.position - a.position),
          (a.normal + part * (b.normal - a.normal)).normalized(),
          a.uv + part * (b.uv - a.uv),
          {mix(a.colour.r, b.colour.r), mix(a.colour.g, b.colour.g), mix(a.colour.b, b.colour.b)}};
}

/// The part of a triangle where `height` of a corner is not above 0 (Sutherland and Hodgman 1974).
template <class Height>
std::vector<Corner> below(const std::array<Corner, 3>& triangle, Height height) {
  std::vector<Corner> kept;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner &a = triangle[k], &b = triangle[(k + 1) % 3];
    const float ha = height(a), hb = height(b);
    if (ha <= 0.0F) kept.push_back(a);
    if ((ha < 0.0F && hb > 0.0F) || (ha > 0.0F && hb < 0.0F)) kept.push_back(between(a, b, ha / (ha - hb)));
  }
  return kept;
}

world::Mesh cut(const world::MeshInstance& instance, const Eigen::Isometry3d& T_world_shape, double height_m) {
  const world::Mesh& all = *instance.mesh;
  const Eigen::Affine3f T = (T_world_shape * Eigen::Scaling(instance.scale)).cast<float>();
  const auto corner = [&](std::size_t i) {
    const std::size_t v = all.indices[i];
    return Corner{all.vertices[v], all.normals.empty() ? Eigen::Vector3f::UnitZ() : all.normals[v],
                  all.uvs.empty() ? Eigen::Vector2f::Zero() : all.uvs[v], all.colours.empty() ? Rgb{} : all.colours[v]};
  };
  const auto over = [&](const Corner& c) { return (T * c.position).z() - static_cast<float>(height_m); };
  world::Mesh rest;
  for (std::size_t i = 0; i + 2 < all.indices.size(); i += 3) {
    const auto polygon = below({corner(i), corner(i + 1), corner(i + 2)}, over);
    const auto first = static_cast<std::uint32_t>(rest.vertices.size());
    for (const Corner& c : polygon) {
      rest.vertices.push_back(c.position);
      rest.normals.push_back(c.normal);
      if (!all.uvs.empty()) rest.uvs.push_back(c.uv);
      if (!all.colours.empty()) rest.colours.push_back(c.colour);
    }
    for (std::uint32_t k = 2; k < polygon.size(); ++k)
      rest.indices.insert(rest.indices.end(), {first, first + k - 1, first + k});
  }
  return rest;
}

/// The same triangles seen from behind, a little behind.
world::Mesh lining_of(const world::Mesh& mesh, const Eigen::Vector3d& scale) {
  world::Mesh lining{mesh.vertices, mesh.normals, {}, {}, mesh.indices};
  for (std::size_t i = 0; i < lining.vertices.size(); ++i) {
    lining.vertices[i] -= kLining_m * lining.normals[i].cwiseQuotient(scale.cast<float>().cwiseAbs());
    lining.normals[i] = -lining.normals[i];
  }
  for (std::size_t i = 0; i + 2 < lining.indices.size(); i += 3) std::swap(lining.indices[i], lining.indices[i + 1]);
  return lining;
}

/// An upright box or cylinder of `length` along z, shortened from above.
Eigen::Isometry3d shortened(const Eigen::Isometry3d& T_body_shape, double& length, double cut_off_m) {
  length -= cut_off_m;
  return T_body_shape * Eigen::Translation3d(0.0, 0.0, -0.5 * cut_off_m);
}

void append_cut(const world::Shape& shape, const Eigen::Isometry3d& T_world_body, const Section& section,
                std::vector<world::Shape>& out) {
  const Eigen::Isometry3d T = T_world_body * shape.T_body_shape;
  const Eigen::AlignedBox3d box = world::bounds(shape.geometry, T);
  if (box.max().z() <= section.tall_m) return out.push_back(shape);
  if (box.min().z() >= section.height_m) return;
  world::Shape rest = shape;
  const bool upright = T.linear()(2, 2) > 1.0 - 1e-6;
  const double cut_off_m = box.max().z() - section.height_m;
  if (auto* b = std::get_if<world::Box>(&rest.geometry); b != nullptr && upright) {
    rest.T_body_shape = shortened(rest.T_body_shape, b->size.z(), cut_off_m);
  } else if (auto* c = std::get_if<world::Cylinder>(&rest.geometry); c != nullptr && upright) {
    rest.T_body_shape = shortened(rest.T_body_shape, c->length, cut_off_m);
  } else if (auto* m = std::get_if<world::MeshInstance>(&rest.geometry); m != nullptr && m->mesh) {
    const world::Mesh mesh = cut(*m, T, section.height_m);
    world::Shape lining = shape;
    lining.material = {.diffuse = kDark, .specular = 0.0F, .texture = nullptr};
    lining.geometry = world::MeshInstance{std::make_shared<world::Mesh>(lining_of(mesh, m->scale)), m->scale};
    m->mesh = std::make_shared<world::Mesh>(mesh);
    out.push_back(std::move(lining));
  }
  out.push_back(std::move(rest));
}

}  // namespace

world::Body cut_open(world::Body body, const Section& section) {
  std::vector<world::Shape> rest;
  for (const world::Shape& shape : body.visuals) append_cut(shape, body.pose.T, section, rest);
  body.visuals = std::move(rest);
  return body;
}

}  // namespace amiss::video
