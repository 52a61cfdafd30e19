#include "world/internal/tree_builder.hpp"

#include <algorithm>
#include <cmath>
#include <sdf/Collision.hh>
#include <sdf/Frame.hh>
#include <sdf/Light.hh>
#include <sdf/Link.hh>
#include <sdf/Model.hh>
#include <sdf/Root.hh>
#include <sdf/Scene.hh>
#include <sdf/SemanticPose.hh>
#include <sdf/Visual.hh>
#include <sdf/World.hh>
#include <sdf/parser.hh>

#include "core/result.hpp"
#include "world/internal/sdf_grammar.hpp"

namespace amiss::world {
namespace {

Eigen::Vector3f colour_of(const ignition::math::Color& c) { return {c.R(), c.G(), c.B()}; }

Eigen::Isometry3d isometry_of(const ignition::math::Pose3d& pose) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  if (!pose.IsFinite()) return T;
  T.translate(Eigen::Vector3d(pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z()));
  T.rotate(Eigen::Quaterniond(pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z()).normalized());
  return T;
}

std::optional<Light> directional(const sdf::Light& source) {
  if (source.Type() != sdf::LightType::DIRECTIONAL) return std::nullopt;
  const Eigen::Vector3d local(source.Direction().X(), source.Direction().Y(), source.Direction().Z());
  const Eigen::Vector3d turned = isometry_of(source.RawPose()).linear() * local;
  if (!turned.allFinite() || turned.norm() < 1e-9) return std::nullopt;
  return Light{turned.normalized().cast<float>(), colour_of(source.Diffuse()).cwiseMax(0.0F).cwiseMin(1.0F)};
}

std::optional<double> friction_of(const sdf::Collision& collision) {
  sdf::ElementPtr element = collision.Element();
  for (const char* name : {"surface", "friction", "ode", "mu"}) {
    if (element == nullptr || !element->HasElement(name)) return std::nullopt;
    element = element->GetElement(name);
  }
  const double mu = element->Get<double>();
  return std::isfinite(mu) && mu >= 0.0 ? std::optional(std::min(mu, 10.0)) : std::nullopt;
}

class Builder {
 public:
  Builder(const SdfText& text, const std::filesystem::path& file, ShapeReader& shapes,
          std::vector<std::string>& warnings)
      : text_(text), file_(file), shapes_(shapes), warnings_(warnings) {}

  FileTree run() {
    sdf::Root root;
    const sdf::Errors errors = parse(root);
    const bool usable = text_.is_world ? root.WorldCount() > 0 : root.Model() != nullptr || root.Light() != nullptr;
    if (!usable) throw InputError(sentence(errors));
    for (const sdf::Error& error : errors) warnings_.push_back(sentence({error}));
    if (text_.is_world) {
      take_world(*root.WorldByIndex(0));
    } else {
      if (root.Model() != nullptr) take_model(*root.Model(), root.Model()->Name());
      if (root.Light() != nullptr) take_light(*root.Light());
    }
    out_.lights.insert(out_.lights.end(), text_.lights.begin(), text_.lights.end());
    return std::move(out_);
  }

 private:
  sdf::Errors parse(sdf::Root& root) const {
    const sdf::SDFPtr& grammar = sdf_grammar();
    grammar->Root()->ClearElements();  // of the file before
    sdf::ParserConfig config;
    config.SetFindCallback([](const std::string&) { return std::string(); });
    sdf::Errors errors;
    if (!sdf::readString(text_.text, config, grammar, errors) && errors.empty()) {
      errors.emplace_back(sdf::ErrorCode::STRING_READ, "libsdformat cannot read it");
    }
    const sdf::Errors more = root.Load(grammar, config);
    errors.insert(errors.end(), more.begin(), more.end());
    return errors;
  }

  /// One sentence out of what the library says: the first error, with the line of the element that it names.
  std::string sentence(const sdf::Errors& errors) const {
    std::string message = errors.empty() ? "nothing usable in it" : errors.front().Message();
    std::replace(message.begin(), message.end(), '\n', ' ');
    const std::size_t first = message.find('['), last = message.find(']', first);
    const auto line = first == std::string::npos || last == std::string::npos
                          ? text_.lines.end()
                          : text_.lines.find(message.substr(first + 1, last - first - 1));
    const std::string place = line != text_.lines.end() ? ":" + std::to_string(line->second) : "";
    return file_.string() + place + ": " + message;
  }

  /// The pose in the frame of the enclosing element; where the frames are broken, the raw numbers with a warning.
  Eigen::Isometry3d resolved(const sdf::SemanticPose& pose, const std::string& what, const std::string& to = "") {
    ignition::math::Pose3d resolved;
    if (pose.Resolve(resolved, to).empty()) return isometry_of(resolved);
    warnings_.push_back(file_.string() + ": the pose of " + what + " cannot be resolved against '" + pose.RelativeTo() +
                        "', its numbers are taken as they stand");
    return isometry_of(pose.RawPose());
  }

  void take_world(const sdf::World& world) {
    out_.is_world = true;
    out_.world_name = world.Name();
    if (world.Scene() != nullptr) {
      out_.ambient = colour_of(world.Scene()->Ambient());
      out_.background = colour_of(world.Scene()->Background());
    }
    for (std::uint64_t i = 0; i < world.LightCount(); ++i) take_light(*world.LightByIndex(i));
    for (std::uint64_t i = 0; i < world.ModelCount(); ++i) {
      take_model(*world.ModelByIndex(i), world.ModelByIndex(i)->Name());
    }
    for (std::uint64_t i = 0; i < world.FrameCount(); ++i) {
      const sdf::Frame& frame = *world.FrameByIndex(i);
      if (frame.Name() != "robot_start") continue;
      const Eigen::Isometry3d T = resolved(frame.SemanticPose(), "frame 'robot_start'");
      out_.robot_start = Pose2<amiss::World, Base>{T.translation().x(), T.translation().y(),
                                                   std::atan2(T.linear()(1, 0), T.linear()(0, 0))};
    }
  }

  void take_light(const sdf::Light& light) {
    if (const std::optional<Light> made = directional(light)) out_.lights.push_back(*made);
  }

  void take_model(const sdf::Model& model, const std::string& scoped) {
    ModelTree tree;
    tree.name = model.Name();
    tree.is_static = model.Static();
    const auto pose = text_.pose_texts.find(scoped);
    if (pose != text_.pose_texts.end()) tree.pose_text = pose->second;
    tree.T_parent_model =
        out_.is_world ? resolved(model.SemanticPose(), "model '" + scoped + "'") : isometry_of(model.RawPose());
    const auto included = text_.includes.find(scoped);
    if (included != text_.includes.end()) {
      const ModelTree& source = included->second.file->models.front();
      tree.links = source.links;
      tree.joints = source.joints;
      tree.is_static = included->second.is_static.value_or(source.is_static);
    } else {
      collect(model, scoped, "", Eigen::Isometry3d::Identity(), tree);
    }
    out_.models.push_back(std::move(tree));
  }

  /// Links and joints of a model and of the models in it, as seen from the outermost one.
  void collect(const sdf::Model& model, const std::string& scoped, const std::string& prefix,
               const Eigen::Isometry3d& T_top_model, ModelTree& top) {
    for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
      const sdf::Link& link = *model.LinkByIndex(i);
      if (link.Name() == "empty_link_") continue;
      const Eigen::Isometry3d T_model_link =
          resolved(link.SemanticPose(), "link '" + scoped + "::" + link.Name() + "'", "__model__");
      top.links.push_back(link_node(link, prefix, T_top_model * T_model_link));
    }
    const auto ties = text_.joints.find(scoped);
    if (ties != text_.joints.end()) add_ties(ties->second, prefix, top);
    for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
      const sdf::Model& nested = *model.ModelByIndex(i);
      const std::string name = scoped + "::" + nested.Name();
      const Eigen::Isometry3d T_top_nested =
          T_top_model * resolved(nested.SemanticPose(), "model '" + name + "'", "__model__");
      const auto included = text_.includes.find(name);
      if (included == text_.includes.end()) {
        collect(nested, name, prefix + nested.Name() + "::", T_top_nested, top);
      } else {
        add_included(included->second.file->models.front(), prefix + nested.Name() + "::", T_top_nested, top);
      }
    }
  }

  static void add_ties(const std::vector<JointTie>& ties, const std::string& prefix, ModelTree& top) {
    const auto named = [&](const std::string& link) { return link == "world" ? link : prefix + link; };
    for (const JointTie& tie : ties) top.joints.emplace_back(named(tie.first), named(tie.second));
  }

  static void add_included(const ModelTree& source, const std::string& prefix, const Eigen::Isometry3d& T_top_nested,
                           ModelTree& top) {
    for (LinkNode link : source.links) {
      link.name = prefix + link.name;
      link.T_model_link = T_top_nested * link.T_model_link;
      top.links.push_back(std::move(link));
    }
    add_ties(source.joints, prefix, top);
  }

  LinkNode link_node(const sdf::Link& link, const std::string& prefix, const Eigen::Isometry3d& T_model_link) {
    LinkNode node;
    node.name = prefix + link.Name();
    node.T_model_link = T_model_link;
    node.mass_kg = link.Inertial().MassMatrix().Mass();
    for (std::uint64_t i = 0; i < link.VisualCount(); ++i) {
      const sdf::Visual& visual = *link.VisualByIndex(i);
      add_shapes(shapes_.read(visual, file_), resolved(visual.SemanticPose(), "visual '" + visual.Name() + "'"),
                 node.visuals);
    }
    for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
      const sdf::Collision& collision = *link.CollisionByIndex(i);
      add_shapes(shapes_.read(collision, file_),
                 resolved(collision.SemanticPose(), "collision '" + collision.Name() + "'"), node.collisions);
      if (!node.friction) node.friction = friction_of(collision);
    }
    return node;
  }

  static void add_shapes(std::vector<Shape> shapes, const Eigen::Isometry3d& T_link_element, std::vector<Shape>& to) {
    for (Shape& shape : shapes) {
      shape.T_body_shape = T_link_element * shape.T_body_shape;
      to.push_back(std::move(shape));
    }
  }

  const SdfText& text_;
  const std::filesystem::path& file_;
  ShapeReader& shapes_;
  std::vector<std::string>& warnings_;
  FileTree out_;
};

}  // namespace

FileTree build_tree(const SdfText& text, const std::filesystem::path& file, ShapeReader& shapes,
                    std::vector<std::string>& warnings) {
  return Builder(text, file, shapes, warnings).run();
}

}  // namespace amiss::world
