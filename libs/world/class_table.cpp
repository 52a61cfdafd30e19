#include "world/class_table.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "core/files.hpp"
#include "core/params.hpp"
#include "core/result.hpp"

namespace amiss::world {
namespace {

constexpr std::size_t kMaxBytes = 1U << 20U;

bool begins(std::string_view name, std::string_view beginning) {
  if (!name.starts_with(beginning)) return false;
  const std::string_view rest = name.substr(beginning.size());
  return rest.empty() || rest.starts_with("_") || rest.starts_with("::");
}

std::string where(const std::filesystem::path& file, const YAML::Mark& mark) {
  return file.string() + ":" + std::to_string(std::max(0, mark.line) + 1) + ": ";
}

SemanticClass class_named(const std::filesystem::path& file, const YAML::Node& node) {
  const std::string name = node.IsScalar() ? node.Scalar() : "";
  if (const auto value = semantic_class_of(name)) return *value;
  std::vector<std::string> names;
  for (const NamedSemanticClass& named : kSemanticClasses) names.emplace_back(named.name);
  const std::string near = nearest_word(name, names);
  throw InputError(where(file, node.Mark()) + "'" + name + "' is no semantic class" +
                   (near.empty() ? "; allowed are those of ScanNet and otherprop" : "; did you mean '" + near + "'?"));
}

std::vector<ClassTable::Row> rows_of(const std::filesystem::path& file, const YAML::Node& root) {
  if (!root.IsMap()) throw InputError(file.string() + ":1: not a map; allowed is CLASS: [NAME, ..] for each class");
  std::vector<ClassTable::Row> rows;
  for (const auto& pair : root) {
    const SemanticClass value = class_named(file, pair.first);
    if (!pair.second.IsSequence()) {
      throw InputError(where(file, pair.first.Mark()) + pair.first.Scalar() + " is not a list of names");
    }
    for (const YAML::Node& item : pair.second) {
      if (!item.IsScalar() || item.Scalar().empty()) throw InputError(where(file, item.Mark()) + "not a name");
      const auto same = [&](const ClassTable::Row& row) { return row.beginning == item.Scalar(); };
      if (std::any_of(rows.begin(), rows.end(), same)) {
        throw InputError(where(file, item.Mark()) + "'" + item.Scalar() + "' is there twice; a name has one class");
      }
      rows.push_back({item.Scalar(), value});
    }
  }
  return rows;
}

}  // namespace

SemanticClass ClassTable::class_of(std::string_view body_name) const {
  const Row* best = nullptr;
  for (const Row& row : rows_) {
    if (begins(body_name, row.beginning) && (best == nullptr || row.beginning.size() > best->beginning.size())) {
      best = &row;
    }
  }
  return best == nullptr ? SemanticClass::kUnlabelled : best->value;
}

ClassTable load_class_table(const std::filesystem::path& file) {
  try {
    return ClassTable(rows_of(file, YAML::Load(load_bytes(file, kMaxBytes))));
  } catch (const YAML::Exception& error) {
    throw InputError(where(file, error.mark) + "not YAML: " + error.msg);
  }
}

ClassTable class_table_beside(const World& world) {
  const std::filesystem::path file = world.file.parent_path() / "classes.yaml";
  return std::filesystem::exists(file) ? load_class_table(file) : ClassTable();
}

}  // namespace amiss::world
