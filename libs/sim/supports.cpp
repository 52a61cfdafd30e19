#include "sim/supports.hpp"

#include <cmath>
#include <numbers>

namespace amiss::sim {
namespace {

constexpr double kLevel = 0.9986;       // cosine of 3 degrees
constexpr double kStandsWithin_m = 0.02;

/// The top of a box that has one of its axes upright.
std::optional<Support> top_of(const world::Box& box, const Eigen::Isometry3d& T_world_box) {
  for (int up = 0; up < 3; ++up) {
    const double cosine = T_world_box.linear()(2, up);
    if (std::abs(cosine) < kLevel) continue;
    const int u = (up + 1) % 3, v = (up + 2) % 3;
    Support top;
    top.T_world_top.linear().col(2) = T_world_box.linear().col(up) * (cosine > 0.0 ? 1.0 : -1.0);
    top.T_world_top.linear().col(0) = T_world_box.linear().col(u);
    top.T_world_top.linear().col(1) = top.T_world_top.linear().col(2).cross(top.T_world_top.linear().col(0));
    top.T_world_top.translation() = T_world_box.translation() + top.T_world_top.linear().col(2) * box.size[up] / 2.0;
    top.half_m = {box.size[u] / 2.0, box.size[v] / 2.0};
    return top;
  }
  return std::nullopt;
}

std::optional<Support> top_of(const world::Cylinder& disc, const Eigen::Isometry3d& T_world_disc) {
  if (std::abs(T_world_disc.linear()(2, 2)) < kLevel || disc.length > disc.radius) return std::nullopt;
  Support top;
  top.is_round = true;
  top.half_m = Eigen::Vector2d::Constant(disc.radius);
  top.T_world_top.translation() = T_world_disc.translation() + Eigen::Vector3d(0.0, 0.0, disc.length / 2.0);
  return top;
}

std::optional<Support> top_of(const world::Shape& shape, const Eigen::Isometry3d& T_world_body) {
  const Eigen::Isometry3d T = T_world_body * shape.T_body_shape;
  if (const auto* box = std::get_if<world::Box>(&shape.geometry)) return top_of(*box, T);
  if (const auto* disc = std::get_if<world::Cylinder>(&shape.geometry)) return top_of(*disc, T);
  return std::nullopt;
}

}  // namespace

double Support::area_m2() const { return (is_round ? std::numbers::pi : 4.0) * half_m.x() * half_m.y(); }

bool Support::is_over(const Eigen::Vector2d& p_world, double margin_m) const {
  const Eigen::Vector3d p = T_world_top.inverse() * Eigen::Vector3d(p_world.x(), p_world.y(), height_m());
  if (is_round) return p.head<2>().norm() <= half_m.x() - margin_m;
  return std::abs(p.x()) <= half_m.x() - margin_m && std::abs(p.y()) <= half_m.y() - margin_m;
}

std::vector<Support> find_supports(const world::World& world, const SupportParams& params) {
  std::vector<Support> supports;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const world::Body& body = world.bodies[i];
    if (!body.is_static) continue;
    for (const world::Shape& shape : body.collisions) {
      std::optional<Support> top = top_of(shape, body.pose.T);
      if (!top || 2.0 * top->half_m.minCoeff() < params.min_edge_m) continue;
      if (top->height_m() < params.min_height_m || top->height_m() > params.max_height_m) continue;
      top->body = i;
      supports.push_back(*top);
    }
  }
  return supports;
}

std::optional<Support> support_under(const std::vector<Support>& supports, const Eigen::Vector3d& foot,
                                     std::optional<std::size_t> not_this) {
  std::optional<Support> best;
  double least_m = kStandsWithin_m;
  for (const Support& support : supports) {
    const double gap_m = std::abs(support.height_m() - foot.z());
    if (support.body == not_this || gap_m > least_m || !support.is_over(foot.head<2>())) continue;
    best = support;
    least_m = gap_m;
  }
  return best;
}

}  // namespace amiss::sim
