#include "sim/internal/falling.hpp"

#include <cmath>
#include <numbers>

namespace amiss::sim::internal {
namespace {

using namespace std::chrono_literals;
constexpr auto kLongestSettling = 6s;
constexpr auto kStep = 20ms;

}  // namespace

Eigen::Isometry3d random_turn(RandomStream& random) {
  const double yaw = random.uniform(-std::numbers::pi, std::numbers::pi);
  Eigen::Isometry3d turn(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
  if (random.uniform() < 0.5) return turn;
  const double about = random.uniform(-std::numbers::pi, std::numbers::pi);
  const Eigen::Vector3d axis(std::cos(about), std::sin(about), 0.0);
  return turn * Eigen::AngleAxisd(random.uniform(0.0, std::numbers::pi), axis);
}

Turned turned(const world::Body& body, const Eigen::Isometry3d& turn) {
  Turned result{body, {}};
  result.body.is_static = false;
  result.body.pose.T = turn;
  Physics alone(world::World{});
  result.bounds = alone.bounds(alone.add(result.body));
  return result;
}

bool settle(Physics& physics, std::size_t body) {
  for (auto time = 0ms; time < kLongestSettling && !physics.is_asleep(body); time += kStep) physics.step(kStep);
  return physics.is_asleep(body);
}

bool settle(Physics& physics) {
  for (auto time = 0ms; time < kLongestSettling && !physics.all_asleep(); time += kStep) physics.step(kStep);
  return physics.all_asleep();
}

}  // namespace amiss::sim::internal
