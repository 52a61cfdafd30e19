// A room for tests of detection: floor, the lower part of two walls, table, things, as points 1 cm apart with a little
// noise.
#pragma once

#include <cmath>
#include <numbers>

#include "change/novel.hpp"
#include "core/random.hpp"

namespace amiss::change {

class Room {
 public:
  explicit Room(std::uint64_t seed) : random_(seed, "room") {
    patch({-0.4F, -0.5F, 0.0F}, {2.0F, 0, 0}, {0, 1.6F, 0}, {120, 100, 80}, SemanticClass::kFloor);
    patch({-0.4F, 1.1F, 0.0F}, {2.0F, 0, 0}, {0, 0, 0.3F}, {200, 200, 190}, SemanticClass::kWall);
    patch({-0.4F, -0.5F, 0.0F}, {0, 1.6F, 0}, {0, 0, 0.3F}, {200, 200, 190}, SemanticClass::kWall);
    box({0, 0, 0.68F}, {1.2F, 0.7F, 0.02F}, 0.0F, {150, 110, 70}, SemanticClass::kTable);
  }

  /// The four sides and the top of a box; `corner` is the lowest one, the box turns about its middle.
  void box(const Eigen::Vector3f& corner, const Eigen::Vector3f& size, float yaw, Rgb colour, SemanticClass value) {
    const Eigen::Vector3f middle = corner + 0.5F * size;
    const Eigen::AngleAxisf turn(yaw, Eigen::Vector3f::UnitZ());
    const auto place = [&](float x, float y, float z) {
      Eigen::Vector3f p = corner + Eigen::Vector3f(x, y, z) - middle;
      p = turn * p;
      return Eigen::Vector3f(p + middle);
    };
    const auto side = [&](const Eigen::Vector3f& at, const Eigen::Vector3f& u, const Eigen::Vector3f& v) {
      patch(place(at.x(), at.y(), at.z()), turn * u, turn * v, colour, value);
    };
    const Eigen::Vector3f x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
    side({0, 0, 0}, x, z);
    side({0, size.y(), 0}, x, z);
    side({0, 0, 0}, y, z);
    side({size.x(), 0, 0}, y, z);
    side(z, x, y);
  }

  /// The points that were added since the room had `from` points.
  [[nodiscard]] segment::Indices since(std::size_t from) const {
    segment::Indices all;
    for (std::size_t i = from; i < scene_.cloud.points.size(); ++i) all.push_back(static_cast<std::uint32_t>(i));
    return all;
  }
  [[nodiscard]] std::size_t size() const { return scene_.cloud.points.size(); }

  [[nodiscard]] Scene scene(bool labelled = false) const {
    Scene out = scene_;
    if (!labelled) out.labels.clear();
    return out;
  }
  /// The same from a robot that believes to be elsewhere.
  [[nodiscard]] Scene shifted(const Eigen::Vector3f& shift, float yaw, bool labelled = false) const {
    Scene out = scene(labelled);
    for (Eigen::Vector3f& p : out.cloud.points) p = Eigen::AngleAxisf(yaw, Eigen::Vector3f::UnitZ()) * p + shift;
    return out;
  }

 private:
  void patch(const Eigen::Vector3f& at, const Eigen::Vector3f& u, const Eigen::Vector3f& v, Rgb colour,
             SemanticClass value) {
    const auto steps = [](const Eigen::Vector3f& edge) { return std::max(1, static_cast<int>(edge.norm() / 0.01F)); };
    const int nu = steps(u), nv = steps(v);
    for (int a = 0; a < nu; ++a) {
      for (int b = 0; b < nv; ++b) {
        const float s = (static_cast<float>(a) + 0.5F) / static_cast<float>(nu);
        const float t = (static_cast<float>(b) + 0.5F) / static_cast<float>(nv);
        const auto draw = [&] { return static_cast<float>(random_.uniform(-0.0015, 0.0015)); };
        const float dx = draw(), dy = draw(), dz = draw();
        scene_.cloud.points.emplace_back(at + s * u + t * v + Eigen::Vector3f(dx, dy, dz));
        scene_.cloud.colours.push_back(colour);
        scene_.labels.push_back(value);
      }
    }
  }

  RandomStream random_;
  Scene scene_;
};

inline constexpr Rgb kRed{200, 30, 30}, kGrey{90, 90, 90}, kBlue{30, 40, 190};

/// A lamp: foot, post up to the top of its shade, shade; permanent, at x on the table.
inline void add_lamp(Room& room, float x, float y, float yaw = 0.0F) {
  room.box({x, y, 0.70F}, {0.12F, 0.12F, 0.03F}, yaw, kGrey, SemanticClass::kOtherProp);
  room.box({x + 0.04F, y + 0.04F, 0.73F}, {0.04F, 0.04F, 0.34F}, yaw, kGrey, SemanticClass::kOtherProp);
  room.box({x - 0.03F, y - 0.03F, 0.95F}, {0.18F, 0.18F, 0.12F}, yaw, kGrey, SemanticClass::kOtherProp);
}
inline void add_keyboard(Room& room, float x, float y, float yaw = 0.0F) {
  room.box({x, y, 0.70F}, {0.40F, 0.14F, 0.035F}, yaw, kGrey, SemanticClass::kOtherProp);
}
inline void add_can(Room& room, float x, float y, Rgb colour = kRed) {
  room.box({x, y, 0.70F}, {0.07F, 0.07F, 0.11F}, 0.0F, colour, SemanticClass::kOtherProp);
}

}  // namespace amiss::change
