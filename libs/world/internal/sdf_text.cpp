#include "world/internal/sdf_text.hpp"

#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <set>
#include <sstream>
#include <string_view>

#include "core/files.hpp"
#include "core/result.hpp"
#include "world/internal/inertia.hpp"
#include "world/internal/xml.hpp"

namespace amiss::world {
namespace {

using tinyxml2::XMLElement;

constexpr std::array kWorldChildren = {"model", "include", "light", "scene", "frame"};
constexpr std::array kModelChildren = {"pose", "static", "model", "include", "link", "joint", "frame"};
constexpr std::array kLinkChildren = {"pose", "inertial", "visual", "collision"};
constexpr std::array kNamedChildren = {"model", "link", "joint", "frame", "visual", "collision", "light"};

template <std::size_t N>
bool is_one_of(const XMLElement& element, const std::array<const char*, N>& names) {
  return std::any_of(names.begin(), names.end(), [&](const char* name) { return is_named(element, name); });
}

class Preparer {
 public:
  Preparer(const std::filesystem::path& file, const IncludeReader& read_include)
      : file_(file), read_include_(read_include) {}

  SdfText run() {
    parse_xml(document_, load_bytes(file_, kMaxSdfBytes), file_.string());
    XMLElement* root = document_.FirstChildElement("sdf");
    if (root == nullptr) root = document_.FirstChildElement("gazebo");
    if (root == nullptr) throw InputError(file_.string() + ": no <sdf> element in it; allowed are SDF files");
    if (root->Attribute("version") == nullptr) {
      warn(*root, "no version given, 1.6 is assumed");
      root->SetAttribute("version", "1.6");
    }
    version_ = root->DoubleAttribute("version", 1.6);
    XMLElement* world = root->FirstChildElement("world");
    out_.is_world = world != nullptr;
    if (world != nullptr) {
      prepare_world(*root, *world);
    } else {
      prepare_single_model(*root);
    }
    tinyxml2::XMLPrinter printer(nullptr, true);
    document_.Print(&printer);
    out_.text = printer.CStr();
    return std::move(out_);
  }

 private:
  std::string where(const XMLElement& element) const {
    return file_.string() + ":" + std::to_string(element.GetLineNum());
  }
  void warn(int line, const std::string& what) {
    out_.warnings.push_back(file_.string() + ":" + std::to_string(line) + ": " + what);
  }
  void warn(const XMLElement& element, const std::string& what) { warn(element.GetLineNum(), what); }

  void prepare_world(XMLElement& root, XMLElement& world) {
    for (XMLElement* extra : children(root)) {
      if (extra == &world) continue;
      if (is_named(*extra, "world")) warn(*extra, "a second world in one file is left out");
      root.DeleteChild(extra);
    }
    if (world.Attribute("name") == nullptr) world.SetAttribute("name", "world");
    apply_state(world);
    for (XMLElement* child : children(world)) {
      if (is_named(*child, "actor") || is_named(*child, "population") || is_named(*child, "road")) {
        warn(*child, std::string("<") + child->Name() + "> is left out");
      }
      if (!is_one_of(*child, kWorldChildren)) world.DeleteChild(child);
    }
    prepare_siblings(world, "");
  }

  /// A saved world keeps the poses that count in <state>.
  static void apply_state(XMLElement& world) {
    const XMLElement* state = world.FirstChildElement("state");
    if (state == nullptr) return;
    for (const XMLElement* saved = state->FirstChildElement("model"); saved != nullptr;
         saved = saved->NextSiblingElement("model")) {
      const XMLElement* pose = saved->FirstChildElement("pose");
      if (pose == nullptr || pose->GetText() == nullptr) continue;
      for (XMLElement* model : children(world)) {
        if (is_named(*model, "model") && text_of_attribute(*model, "name") == text_of_attribute(*saved, "name")) {
          if (XMLElement* old = model->FirstChildElement("pose")) model->DeleteChild(old);
          model->InsertNewChildElement("pose")->SetText(pose->GetText());
        }
      }
    }
  }

  void prepare_single_model(XMLElement& root) {
    bool found = false;
    for (XMLElement* child : children(root)) {
      const bool keep = is_named(*child, "light") || (is_named(*child, "model") && !found);
      found = found || is_named(*child, "model");
      if (!keep) root.DeleteChild(child);
    }
    if (root.FirstChildElement() == nullptr) {
      throw InputError(where(root) + ": neither a <world> nor a <model> in it; one of them is needed");
    }
    prepare_siblings(root, "");
  }

  /// Children of a world or a model, `scope` being "" or the model's scoped name.
  void prepare_siblings(XMLElement& parent, const std::string& scope) {
    std::set<std::string> names;
    for (XMLElement* child : children(parent)) {
      if (is_one_of(*child, kNamedChildren)) make_name_unique(*child, names, child->GetLineNum());
    }
    for (XMLElement* child : children(parent)) {
      if (is_named(*child, "include")) replace_include(parent, *child, scope, names);
    }
    for (XMLElement* child : children(parent)) {
      const std::string scoped =
          scope.empty() ? text_of_attribute(*child, "name") : scope + "::" + text_of_attribute(*child, "name");
      if (is_named(*child, "model") && out_.includes.count(scoped) == 0) prepare_model(*child, scoped);
      if (is_named(*child, "link")) prepare_link(*child);
      if (is_named(*child, "joint")) prepare_joint(parent, *child, scope);
    }
  }

  void make_name_unique(XMLElement& element, std::set<std::string>& names, int line) {
    const std::string wanted = text_of_attribute(element, "name");
    std::string name = wanted.empty() ? std::string(element.Name()) : wanted;
    if (name == "world" || name == "__root__") name += "_";
    for (int i = 2; !names.insert(name).second; ++i)
      name = (wanted.empty() ? element.Name() : wanted) + "_" + std::to_string(i);
    if (name != wanted) {
      warn(line, std::string("<") + element.Name() + "> named '" + wanted + "' is renamed to '" + name +
                     "', names must be there and unique");
      element.SetAttribute("name", name.c_str());
    }
    out_.lines.emplace(name, line);
  }

  void prepare_model(XMLElement& model, const std::string& scoped) {
    out_.pose_texts[scoped] = text_of_child(model, "pose");
    for (XMLElement* child : children(model)) {
      if (!is_one_of(*child, kModelChildren)) model.DeleteChild(child);
    }
    prepare_siblings(model, scoped);
    if (model.FirstChildElement("link") == nullptr && model.FirstChildElement("model") == nullptr) {
      model.InsertNewChildElement("link")->SetAttribute("name", "empty_link_");
    }
  }

  void prepare_link(XMLElement& link) {
    std::set<std::string> names;
    for (XMLElement* child : children(link)) {
      if (!is_one_of(*child, kLinkChildren)) {
        link.DeleteChild(child);
        continue;
      }
      if (is_one_of(*child, kNamedChildren)) make_name_unique(*child, names, child->GetLineNum());
      if (is_named(*child, "inertial")) {
        for (const std::string& fault : repair_inertial(*child)) {
          warn(*child, "link '" + text_of_attribute(link, "name") + "': " + fault);
        }
      }
    }
  }

  /// A joint becomes a tie, and a frame at its child, so that poses may still refer to it.
  void prepare_joint(XMLElement& model, XMLElement& joint, const std::string& scope) {
    const std::string parent = text_of_child(joint, "parent"), child = text_of_child(joint, "child");
    if (!parent.empty() && !child.empty()) out_.joints[scope].emplace_back(parent, child);
    if (version_ < 1.65 || child.empty() || child == "world") {
      model.DeleteChild(&joint);
      return;
    }
    for (XMLElement* part : children(joint)) {
      if (!is_named(*part, "pose")) joint.DeleteChild(part);
    }
    joint.SetName("frame");
    joint.DeleteAttribute("type");
    joint.SetAttribute("attached_to", child.c_str());
  }

  void replace_include(XMLElement& parent, XMLElement& include, const std::string& scope,
                       std::set<std::string>& names) {
    const std::shared_ptr<const FileTree> file = read_include_(text_of_child(include, "uri"), where(include));
    if (file == nullptr || file->models.empty()) {
      if (file != nullptr) out_.lights.insert(out_.lights.end(), file->lights.begin(), file->lights.end());
      parent.DeleteChild(&include);
      return;
    }
    const ModelTree& tree = file->models.front();
    IncludedModel included{file, std::nullopt};
    const std::string static_text = text_of_child(include, "static");
    if (!static_text.empty()) included.is_static = static_text == "1" || static_text == "true";

    XMLElement& model = *document_.NewElement("model");
    parent.InsertAfterChild(&include, &model);
    const std::string name = text_of_child(include, "name");
    model.SetAttribute("name", (name.empty() ? tree.name : name).c_str());
    make_name_unique(model, names, include.GetLineNum());
    const std::string placement = text_of_child(include, "placement_frame");
    if (!placement.empty() && version_ > 1.75) model.SetAttribute("placement_frame", placement.c_str());
    if (XMLElement* pose = include.FirstChildElement("pose")) {
      model.InsertEndChild(pose);
    } else if (!tree.pose_text.empty()) {
      model.InsertNewChildElement("pose")->SetText(tree.pose_text.c_str());
    }
    add_frames(model, tree);
    const std::string unique = text_of_attribute(model, "name");
    out_.includes[scope.empty() ? unique : scope + "::" + unique] = included;
    parent.DeleteChild(&include);
  }

  /// The links of an included model, so that poses may refer to them.
  static void add_frames(XMLElement& model, const ModelTree& tree) {
    bool any = false;
    for (const LinkNode& link : tree.links) {
      if (link.name.find("::") != std::string::npos) continue;
      XMLElement& element = *model.InsertNewChildElement("link");
      element.SetAttribute("name", link.name.c_str());
      element.InsertNewChildElement("pose")->SetText(pose_text(link.T_model_link).c_str());
      any = true;
    }
    if (!any) model.InsertNewChildElement("link")->SetAttribute("name", "empty_link_");
  }

  const std::filesystem::path& file_;
  const IncludeReader& read_include_;
  tinyxml2::XMLDocument document_;
  double version_ = 1.6;
  SdfText out_;
};

}  // namespace

SdfText prepare_sdf(const std::filesystem::path& file, const IncludeReader& read_include) {
  return Preparer(file, read_include).run();
}

}  // namespace amiss::world
