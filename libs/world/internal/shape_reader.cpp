#include "world/internal/shape_reader.hpp"

#include <algorithm>
#include <cmath>
#include <sdf/Box.hh>
#include <sdf/Capsule.hh>
#include <sdf/Collision.hh>
#include <sdf/Cylinder.hh>
#include <sdf/Ellipsoid.hh>
#include <sdf/Geometry.hh>
#include <sdf/Material.hh>
#include <sdf/Mesh.hh>
#include <sdf/Pbr.hh>
#include <sdf/Plane.hh>
#include <sdf/Sphere.hh>
#include <sdf/Visual.hh>

#include "core/result.hpp"
#include "world/internal/material_script.hpp"
#include "world/internal/mesh_mend.hpp"
#include "world/internal/primitive_meshes.hpp"
#include "world/internal/scene_reader.hpp"

namespace amiss::world {
namespace {

namespace fs = std::filesystem;

Eigen::Vector3d vector_of(const ignition::math::Vector3d& v) { return {v.X(), v.Y(), v.Z()}; }

Eigen::Vector3f colour_of(const ignition::math::Color& c) { return {c.R(), c.G(), c.B()}; }

bool usable(double size) { return std::isfinite(size) && size > 0.0 && size < 1e5; }

bool usable(const Eigen::Vector3d& size) {
  return std::all_of(size.data(), size.data() + 3, [](double edge) { return usable(edge); });
}

std::optional<Geometry> box(const sdf::Box& source) {
  const Box box{vector_of(source.Size())};
  return usable(box.size) ? std::optional<Geometry>(box) : std::nullopt;
}

std::optional<Geometry> cylinder(const sdf::Cylinder& source) {
  const Cylinder made{source.Radius(), source.Length()};
  return usable(made.radius) && usable(made.length) ? std::optional<Geometry>(made) : std::nullopt;
}

std::optional<Geometry> plane(const sdf::Plane& source) {
  const Plane made{vector_of(source.Normal()), {source.Size().X(), source.Size().Y()}};
  const bool good =
      made.normal.allFinite() && made.normal.norm() > 1e-9 && usable(made.size.x()) && usable(made.size.y());
  return good ? std::optional<Geometry>(Plane{made.normal.normalized(), made.size}) : std::nullopt;
}

/// Shapes without a mesh file; nothing for a geometry of another kind or an impossible size.
std::optional<Geometry> primitive(const sdf::Geometry& source) {
  switch (source.Type()) {
    case sdf::GeometryType::BOX:
      return box(*source.BoxShape());
    case sdf::GeometryType::CYLINDER:
      return cylinder(*source.CylinderShape());
    case sdf::GeometryType::PLANE:
      return plane(*source.PlaneShape());
    case sdf::GeometryType::SPHERE:
      return usable(source.SphereShape()->Radius()) ? std::optional<Geometry>(Sphere{source.SphereShape()->Radius()})
                                                    : std::nullopt;
    case sdf::GeometryType::CAPSULE: {
      const double radius = source.CapsuleShape()->Radius(), length = source.CapsuleShape()->Length();
      if (!usable(radius) || !usable(length)) return std::nullopt;
      return MeshInstance{capsule_mesh(radius, length), Eigen::Vector3d::Ones()};
    }
    case sdf::GeometryType::ELLIPSOID: {
      const Eigen::Vector3d radii = vector_of(source.EllipsoidShape()->Radii());
      if (!usable(radii)) return std::nullopt;
      return MeshInstance{ellipsoid_mesh(radii), Eigen::Vector3d::Ones()};
    }
    case sdf::GeometryType::EMPTY:
    case sdf::GeometryType::MESH:
    case sdf::GeometryType::HEIGHTMAP:
      break;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Shape> ShapeReader::read(const sdf::Visual& visual, const fs::path& file) {
  std::vector<Shape> shapes =
      visual.Geom() != nullptr ? read_geometry(*visual.Geom(), file, Use::kDrawn) : std::vector<Shape>();
  for (Shape& shape : shapes) {
    if (visual.Material() != nullptr) shape.material = material_of(*visual.Material(), file, shape.material);
    shape.material.alpha *= 1.0F - std::clamp(visual.Transparency(), 0.0F, 1.0F);
  }
  return shapes;
}

std::vector<Shape> ShapeReader::read(const sdf::Collision& collision, const fs::path& file) {
  return collision.Geom() != nullptr ? read_geometry(*collision.Geom(), file, Use::kTouched) : std::vector<Shape>();
}

std::vector<Shape> ShapeReader::read_geometry(const sdf::Geometry& geometry, const fs::path& file, Use use) {
  if (geometry.Type() == sdf::GeometryType::MESH) return read_mesh(*geometry.MeshShape(), file, use);
  if (const std::optional<Geometry> made = primitive(geometry)) {
    Shape shape;
    shape.geometry = *made;
    return {shape};
  }
  warn_once(file.string() +
            ": a geometry is left out, its size is impossible or its kind is not supported (allowed: "
            "box, cylinder, sphere, plane, capsule, ellipsoid, mesh)");
  return {};
}

std::vector<Shape> ShapeReader::read_mesh(const sdf::Mesh& mesh, const fs::path& file, Use use) {
  const Eigen::Vector3d scale = vector_of(mesh.Scale());
  if (!usable(scale.cwiseAbs())) {
    warn_once(file.string() + ": mesh '" + mesh.Uri() + "' is left out, its scale is impossible");
    return {};
  }
  const LoadedMesh* loaded = mesh_file(mesh.Uri(), file);
  if (loaded == nullptr) return {};
  std::vector<Shape> shapes;
  const bool merged = use == Use::kDrawn && mesh.Submesh().empty();
  for (const MeshPart& part : merged ? loaded->merged : loaded->parts) {
    if (!mesh.Submesh().empty() && part.name != mesh.Submesh()) continue;
    const bool mirrored = scale.prod() < 0.0;
    Shape shape;
    shape.geometry = MeshInstance{mirrored ? inside_out(*part.mesh) : part.mesh, scale};
    shape.material = part.material;
    if (!mesh.Submesh().empty() && mesh.CenterSubmesh()) {
      shape.T_body_shape.translation() = -scale.cwiseProduct(centre_of_bounds(*part.mesh));
    }
    shapes.push_back(std::move(shape));
  }
  if (shapes.empty()) warn_once(file.string() + ": mesh '" + mesh.Uri() + "' has no submesh '" + mesh.Submesh() + "'");
  return shapes;
}

const ShapeReader::LoadedMesh* ShapeReader::mesh_file(const std::string& uri, const fs::path& file) {
  const std::optional<fs::path> path = finder_.find(uri, file.parent_path());
  if (!path) {
    warn_once(file.string() + ": mesh '" + uri + "' is not found and left out");
    return nullptr;
  }
  const auto [entry, is_new] = meshes_.try_emplace(fs::weakly_canonical(*path));
  LoadedMesh& loaded = entry->second;
  if (is_new) {
    try {
      MeshFile mesh = read_mesh_file(*path, textures_);
      for (const std::string& warning : mesh.warnings) warn_once(warning);
      loaded.merged = merged_by_material(mesh.parts);
      loaded.parts = std::move(mesh.parts);
    } catch (const InputError& error) {
      warn_once(std::string(error.what()) + "; the mesh is left out");
    }
  }
  return loaded.parts.empty() ? nullptr : &loaded;
}

Material ShapeReader::material_of(const sdf::Material& source, const fs::path& file, const Material& of_mesh) {
  Material material = of_mesh;
  const sdf::ElementPtr element = source.Element();
  const bool has_diffuse = element != nullptr && element->HasElement("diffuse");
  const bool has_ambient = element != nullptr && element->HasElement("ambient");
  if (has_diffuse || has_ambient) {
    material.texture = nullptr;
    material.diffuse = colour_of(has_diffuse ? source.Diffuse() : source.Ambient());
    material.alpha = has_diffuse ? source.Diffuse().A() : 1.0F;
  }
  if (element != nullptr && element->HasElement("specular")) {
    material.specular = std::clamp(colour_of(source.Specular()).maxCoeff(), 0.0F, 1.0F);
  }
  if (!source.ScriptName().empty()) {
    const std::optional<Material> script = script_material(source, file);
    if (script && !has_diffuse) material = *script;
    if (script && has_diffuse) material.texture = script->texture;
  }
  const sdf::PbrWorkflow* workflow = nullptr;
  if (source.PbrMaterial() != nullptr) {
    workflow = source.PbrMaterial()->Workflow(sdf::PbrWorkflowType::METAL);
    if (workflow == nullptr) workflow = source.PbrMaterial()->Workflow(sdf::PbrWorkflowType::SPECULAR);
  }
  if (workflow != nullptr && !workflow->AlbedoMap().empty()) {
    material.texture = texture(workflow->AlbedoMap(), file);
    if (material.texture != nullptr && !has_diffuse) material.diffuse = Eigen::Vector3f::Ones();
  }
  return material;
}

std::optional<Material> ShapeReader::script_material(const sdf::Material& source, const fs::path& file) {
  const std::string name = source.ScriptName();
  const auto [entry, is_new] = scripts_.try_emplace(file.parent_path().string() + '\n' + name);
  if (!is_new) return entry->second;
  std::vector<fs::path> folders;
  for (sdf::ElementPtr uri = source.Element()->GetElement("script")->FindElement("uri"); uri != nullptr;
       uri = uri->GetNextElement("uri")) {
    if (const std::optional<fs::path> found = finder_.find(uri->Get<std::string>(), file.parent_path())) {
      folders.push_back(*found);
    }
  }
  if (const std::optional<ScriptMaterial> script = find_script_material(name, folders)) {
    entry->second = script->material;
    if (!script->texture.empty()) entry->second->texture = texture(script->texture.string(), file);
  } else if (const std::optional<Eigen::Vector3f> colour = gazebo_colour(name)) {
    entry->second = Material{*colour, 1.0F, 0.1F, nullptr};
  } else {
    warn_once(file.string() + ": material script '" + name + "' is not found, the shape is drawn grey");
  }
  return entry->second;
}

std::shared_ptr<const Texture> ShapeReader::texture(const std::string& uri, const fs::path& file) {
  const std::optional<fs::path> path = finder_.find(uri, file.parent_path());
  if (!path) {
    warn_once(file.string() + ": texture '" + uri + "' is not found and left out");
    return nullptr;
  }
  try {
    return textures_.get(*path);
  } catch (const InputError& error) {
    warn_once(std::string(error.what()) + "; the texture is left out");
    return nullptr;
  }
}

void ShapeReader::warn_once(const std::string& warning) {
  if (said_.insert(warning).second) warnings_.push_back(warning);
}

}  // namespace amiss::world
