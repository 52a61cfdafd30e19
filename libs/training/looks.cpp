#include "training/looks.hpp"

#include <algorithm>
#include <cmath>

namespace amiss::training {

namespace {

constexpr int kEdge_px = 64;

struct Hsv {
  double hue, saturation, value;  // 0 .. 1 each
};

Eigen::Vector3d rgb_of(const Hsv& c) {
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + c.hue * 6.0, 6.0);
    return c.value * (1.0 - c.saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0));
  };
  return {channel(5), channel(3), channel(1)};
}

Rgb pixel_of(const Eigen::Vector3d& colour) {
  const auto byte = [](double v) { return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(v, 0.0, 1.0))); };
  return {byte(colour.x()), byte(colour.y()), byte(colour.z())};
}

/// shade(u, v) says how bright a pixel is, beside 1.
template <class F>
world::Material textured(const Eigen::Vector3d& colour, const F& shade) {
  auto texture = std::make_shared<world::Texture>();
  texture->width = texture->height = kEdge_px;
  for (int v = 0; v < kEdge_px; ++v) {
    for (int u = 0; u < kEdge_px; ++u) texture->pixels.push_back(pixel_of(colour * shade(u, v)));
  }
  world::Material material;
  material.diffuse = Eigen::Vector3f::Ones();
  material.texture = std::move(texture);
  return material;
}

world::Material speckled(const Hsv& hsv, double strength, RandomStream& random) {
  return textured(rgb_of(hsv), [&](int, int) { return 1.0 + strength * random.normal(); });
}

}  // namespace

world::Material random_wood(RandomStream& random) {
  const Hsv hsv{random.uniform(0.05, 0.12), random.uniform(0.2, 0.65), random.uniform(0.35, 0.9)};
  const double period = random.uniform(4, 16), strength = random.uniform(0.02, 0.12), bend = random.uniform(0, 0.2);
  return textured(rgb_of(hsv), [&](int u, int v) {
    return 1.0 + strength * std::sin((v + 6.0 * std::sin(bend * u)) * 6.28 / period) + 0.02 * random.normal();
  });
}

world::Material random_fabric(RandomStream& random) {
  const bool grey = random.uniform() < 0.4;
  const Hsv hsv{random.uniform(), grey ? random.uniform(0, 0.15) : random.uniform(0.2, 0.8), random.uniform(0.2, 0.9)};
  return speckled(hsv, random.uniform(0.02, 0.1), random);
}

world::Material random_paint(RandomStream& random) {
  const Hsv hsv{random.uniform(), random.uniform(0, 0.2), random.uniform(0.65, 1.0)};
  return speckled(hsv, random.uniform(0.0, 0.03), random);
}

world::Material random_plastic(RandomStream& random) {
  return speckled({random.uniform(), random.uniform(), random.uniform(0.1, 1.0)}, 0.02, random);
}

world::Material random_dark(RandomStream& random) {
  return speckled({random.uniform(), random.uniform(0, 0.2), random.uniform(0.05, 0.25)}, 0.03, random);
}

world::Material random_leaf(RandomStream& random) {
  return speckled({random.uniform(0.22, 0.4), random.uniform(0.3, 0.8), random.uniform(0.25, 0.7)}, 0.1, random);
}

world::Material random_print(RandomStream& random) {
  const int columns = 1 + static_cast<int>(random.below(12)), rows = 1 + static_cast<int>(random.below(5));
  std::vector<Eigen::Vector3d> fields;
  for (int i = 0; i < columns * rows; ++i) {
    fields.push_back(rgb_of({random.uniform(), random.uniform(0, 0.8), random.uniform(0.2, 1.0)}));
  }
  auto texture = std::make_shared<world::Texture>();
  texture->width = texture->height = kEdge_px;
  for (int v = 0; v < kEdge_px; ++v) {
    for (int u = 0; u < kEdge_px; ++u) {
      const int field = v * rows / kEdge_px * columns + u * columns / kEdge_px;
      texture->pixels.push_back(pixel_of(fields[static_cast<std::size_t>(field)]));
    }
  }
  world::Material material;
  material.diffuse = Eigen::Vector3f::Ones();
  material.texture = std::move(texture);
  return material;
}

world::Material random_board(RandomStream& random) {
  const double kind = random.uniform();
  if (kind < 0.55) return random_wood(random);
  return kind < 0.9 ? random_paint(random) : random_plastic(random);
}

}  // namespace amiss::training
