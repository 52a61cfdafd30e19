#include "world/internal/sdf_reader.hpp"

#include <algorithm>

#include "core/result.hpp"
#include "world/internal/tree_builder.hpp"

namespace amiss::world {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxIncludeDepth = 20;
constexpr double kGroundEdgeM = 100.0;

/// What Gazebo has on board under these names, for machines without its models.
std::shared_ptr<const FileTree> built_in(const std::string& uri) {
  FileTree tree;
  if (uri == "model://sun") tree.lights.emplace_back();
  if (uri == "model://ground_plane") {
    ModelTree ground;
    ground.name = "ground_plane";
    ground.is_static = true;
    LinkNode link;
    link.name = "link";
    Shape shape;
    shape.geometry = Plane{Eigen::Vector3d::UnitZ(), {kGroundEdgeM, kGroundEdgeM}};
    link.visuals = {shape};
    link.collisions = {shape};
    ground.links = {link};
    tree.models = {ground};
  }
  return tree.models.empty() && tree.lights.empty() ? nullptr : std::make_shared<const FileTree>(std::move(tree));
}

}  // namespace

FileTree SdfReader::read(const fs::path& file) {
  const IncludeReader read_included = [&](const std::string& uri, const std::string& where) {
    return read_include(uri, where, file.parent_path());
  };
  open_.push_back(fs::weakly_canonical(file));
  SdfText text = prepare_sdf(file, read_included);
  warnings_.insert(warnings_.end(), text.warnings.begin(), text.warnings.end());
  FileTree tree = build_tree(text, file, shapes_, warnings_);
  open_.pop_back();
  return tree;
}

std::shared_ptr<const FileTree> SdfReader::read_include(const std::string& uri, const std::string& where,
                                                        const fs::path& folder) {
  const std::optional<fs::path> path = finder_.find_model(uri, folder);
  if (!path) {
    if (std::shared_ptr<const FileTree> known = built_in(uri)) return known;
    warnings_.push_back(where + ": model '" + uri + "' is not found and left out");
    return nullptr;
  }
  const fs::path file = fs::weakly_canonical(*path);
  const auto known = files_.find(file);
  if (known != files_.end()) return known->second;
  if (std::find(open_.begin(), open_.end(), file) != open_.end() || open_.size() > kMaxIncludeDepth) {
    warnings_.push_back(where + ": model '" + uri + "' includes itself and is left out");
    return nullptr;
  }
  std::shared_ptr<const FileTree> tree;
  const std::size_t depth = open_.size();
  try {
    FileTree read_tree = read(file);
    if (read_tree.is_world) throw InputError(file.string() + ": a world cannot be included");
    tree = std::make_shared<const FileTree>(std::move(read_tree));
  } catch (const InputError& error) {
    warnings_.push_back(where + ": model '" + uri + "' is left out: " + error.what());
    open_.resize(depth);
  }
  files_.emplace(file, tree);
  return tree;
}

std::vector<std::string> SdfReader::warnings() const {
  std::vector<std::string> all = warnings_;
  all.insert(all.end(), shapes_.warnings().begin(), shapes_.warnings().end());
  return all;
}

}  // namespace amiss::world
