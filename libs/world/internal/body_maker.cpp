#include "world/internal/body_maker.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace amiss::world {
namespace {

/// Which links move as one: for each link the first link of its group, and whether the group is tied to the world.
struct Groups {
  std::vector<std::size_t> first;
  std::vector<bool> tied_to_world;  // by first link
};

std::size_t root_of(const std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i];
  return i;
}

Groups group_links(const ModelTree& model) {
  const std::size_t n = model.links.size();
  std::vector<std::size_t> parent(n);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  std::vector<bool> tied(n, false);
  const auto index_of = [&](const std::string& name) {
    const auto found =
        std::find_if(model.links.begin(), model.links.end(), [&](const LinkNode& link) { return link.name == name; });
    return static_cast<std::size_t>(found - model.links.begin());
  };
  for (const JointTie& tie : model.joints) {
    const std::size_t a = index_of(tie.first), b = index_of(tie.second);
    if (a < n && b < n) {
      const std::size_t root_a = root_of(parent, a), root_b = root_of(parent, b);
      parent[std::max(root_a, root_b)] = std::min(root_a, root_b);
    } else if (a < n || b < n) {
      if (tie.first == "world" || tie.second == "world") tied[std::min(a, b)] = true;
    }
  }
  Groups groups{std::vector<std::size_t>(n), std::vector<bool>(n, false)};
  for (std::size_t i = 0; i < n; ++i) {
    groups.first[i] = root_of(parent, i);
    if (tied[i]) groups.tied_to_world[groups.first[i]] = true;
  }
  return groups;
}

void add_link(const LinkNode& link, const Eigen::Isometry3d& T_body_link, Body& body) {
  const auto add = [&](const std::vector<Shape>& from, std::vector<Shape>& to) {
    for (Shape shape : from) {
      shape.T_body_shape = T_body_link * shape.T_body_shape;
      to.push_back(std::move(shape));
    }
  };
  add(link.visuals, body.visuals);
  add(link.collisions, body.collisions);
}

Body static_body(const ModelTree& model) {
  Body body;
  body.name = model.name;
  body.pose.T = model.T_parent_model;
  for (const LinkNode& link : model.links) {
    if (link.friction) body.friction = *link.friction;
    add_link(link, link.T_model_link, body);
  }
  return body;
}

}  // namespace

std::vector<Body> make_bodies(const ModelTree& model, std::vector<std::string>& warnings) {
  if (model.links.empty()) return {};
  if (model.is_static) return {static_body(model)};
  const Groups groups = group_links(model);
  std::vector<Body> bodies;
  for (std::size_t first = 0; first < model.links.size(); ++first) {
    if (groups.first[first] != first) continue;
    Body body;
    body.name = model.name + "::" + model.links[first].name;
    body.is_static = groups.tied_to_world[first];
    body.pose.T = model.T_parent_model * model.links[first].T_model_link;
    body.mass_kg = 0.0;
    for (std::size_t i = first; i < model.links.size(); ++i) {
      if (groups.first[i] != first) continue;
      const LinkNode& link = model.links[i];
      body.mass_kg += link.mass_kg;
      if (link.friction) body.friction = *link.friction;
      add_link(link, model.links[first].T_model_link.inverse() * link.T_model_link, body);
    }
    if (!body.is_static && body.collisions.empty()) {
      body.is_static = true;
      warnings.push_back("model '" + model.name + "': '" + body.name +
                         "' has no collision shape and stays where it is");
    }
    bodies.push_back(std::move(body));
  }
  if (bodies.size() == 1) bodies.front().name = model.name;
  if (!model.joints.empty()) {
    warnings.push_back("model '" + model.name + "': its joints are taken as rigid");
  }
  return bodies;
}

void make_names_unique(std::vector<Body>& bodies, std::vector<std::string>& warnings) {
  std::set<std::string> names;
  for (Body& body : bodies) {
    std::string name = body.name;
    for (int i = 2; !names.insert(name).second; ++i) name = body.name + "_" + std::to_string(i);
    if (name != body.name)
      warnings.push_back("body '" + body.name + "' is there twice, one is renamed to '" + name + "'");
    body.name = name;
  }
}

}  // namespace amiss::world
