// A floor, a wall, a table and a ball on it, in points of 1 cm with colours and normals: small enough for every test.
#pragma once

#include <cmath>
#include <numbers>

#include "core/frames.hpp"
#include "core/random.hpp"
#include "core/semantic_class.hpp"

namespace amiss::semantics::test {

struct LabelledRoom {
  Cloud<Map> cloud;
  std::vector<SemanticClass> classes;

  void add(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, const Rgb& colour, SemanticClass value) {
    cloud.points.push_back(p.cast<float>());
    cloud.normals.push_back(normal.cast<float>());
    cloud.colours.push_back(colour);
    classes.push_back(value);
  }
};

/// Where the table stands, and the noise, come from the seed.
inline LabelledRoom labelled_room(std::uint64_t seed) {
  LabelledRoom room;
  RandomStream random(seed, "labelled room");
  const double x0 = random.uniform(0.2, 0.6), y0 = random.uniform(0.2, 0.6), height = random.uniform(0.65, 0.8);
  const auto noise = [&] { return 0.002 * random.normal(); };
  for (double x = 0.005; x < 1.6; x += 0.01) {
    for (double y = 0.005; y < 1.6; y += 0.01) {
      room.add({x, y, noise()}, {0, 0, 1}, {150, 110, 80}, SemanticClass::kFloor);
      if (x > x0 && x < x0 + 0.8 && y > y0 && y < y0 + 0.8) {
        room.add({x, y, height + noise()}, {0, 0, 1}, {230, 230, 225}, SemanticClass::kTable);
      }
    }
  }
  for (double y = 0.005; y < 1.6; y += 0.01) {
    for (double z = 0.005; z < 1.5; z += 0.01)
      room.add({noise(), y, z}, {1, 0, 0}, {235, 235, 230}, SemanticClass::kWall);
  }
  constexpr double kRadius = 0.06;
  const Eigen::Vector3d middle(x0 + 0.4, y0 + 0.4, height + kRadius);
  for (double a = 0; a < 2 * std::numbers::pi; a += 0.12) {
    for (double b = -1.3; b < 1.5; b += 0.12) {
      const Eigen::Vector3d out(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b));
      room.add(middle + kRadius * out, out, {40, 90, 200}, SemanticClass::kOtherProp);
    }
  }
  return room;
}

}  // namespace amiss::semantics::test
