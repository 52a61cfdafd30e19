#include "world/internal/sdf_grammar.hpp"

#include <algorithm>
#include <sdf/Element.hh>
#include <sdf/parser.hh>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "world/internal/sdf_console.hpp"

namespace amiss::world {
namespace {

/// What is read below an element; of one that is not listed everything is kept.
struct Kept {
  std::string_view parent;
  std::vector<std::string_view> children;
};

const std::vector<Kept>& kept_children() {
  static const std::vector<Kept> table = {
      {"sdf", {"world", "model", "light"}},
      {"world", {"model", "light", "scene", "frame"}},
      {"scene", {"ambient", "background"}},
      {"model", {"pose", "static", "model", "link", "frame"}},
      {"link", {"pose", "inertial", "visual", "collision"}},
      {"visual", {"pose", "geometry", "material", "transparency"}},
      {"collision", {"pose", "geometry", "surface"}},
      {"geometry", {"empty", "box", "capsule", "cylinder", "ellipsoid", "mesh", "plane", "sphere"}},
      {"surface", {"friction"}},
      {"friction", {"ode"}},
      {"ode", {"mu"}},
      {"material", {"ambient", "diffuse", "specular", "script", "pbr"}},
      {"metal", {"albedo_map"}},
      {"specular", {"albedo_map"}},  // of pbr; the colour of that name has no children
  };
  return table;
}

bool is_kept(const std::string& parent, const std::string& child) {
  const auto& table = kept_children();
  const auto row = std::find_if(table.begin(), table.end(), [&](const Kept& k) { return k.parent == parent; });
  return row == table.end() || std::find(row->children.begin(), row->children.end(), child) != row->children.end();
}

/// From the inside outwards, so that what is copied is small already.
void cut_down(sdf::Element& element) {
  if (element.GetElementDescriptionCount() == 0) return;
  std::vector<sdf::ElementPtr> kept;
  for (unsigned i = 0; i < element.GetElementDescriptionCount(); ++i) {
    const sdf::ElementPtr child = element.GetElementDescription(i);
    if (!is_kept(element.GetName(), child->GetName())) continue;
    cut_down(*child);
    kept.push_back(child->Clone());
  }
  element.Reset();  // libsdformat can forget only all of them, and empties them too
  for (const sdf::ElementPtr& child : kept) element.AddElementDescription(child);
}

}  // namespace

const sdf::SDFPtr& sdf_grammar() {
  thread_local const sdf::SDFPtr grammar = [] {
    silence_sdf_console();
    auto made = std::make_shared<sdf::SDF>();
    if (!sdf::init(made)) throw std::runtime_error("libsdformat cannot set up its own grammar");
    cut_down(*made->Root());
    return made;
  }();
  return grammar;
}

}  // namespace amiss::world
