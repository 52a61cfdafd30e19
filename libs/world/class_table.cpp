#include "world/class_table.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "core/params.hpp"
#include "core/result.hpp"
#include "core/yaml_checks.hpp"

namespace amiss::world {
namespace {

bool begins(std::string_view name, std::string_view beginning) {
  if (!name.starts_with(beginning)) return false;
  const std::string_view rest = name.substr(beginning.size());
  return rest.empty() || rest.starts_with("_") || rest.starts_with("::");
}

SemanticClass class_named(const std::filesystem::path& file, const YAML::Node& node) {
  const std::string name = node.IsScalar() ? node.Scalar() : "";
  if (const auto value = semantic_class_of(name)) return *value;
  std::vector<std::string> names;
  for (const NamedSemanticClass& named : kSemanticClasses) names.emplace_back(named.name);
  const std::string near = nearest_word(name, names);
  throw InputError(yaml_place(file, node) + "'" + name + "' is no semantic class" +
                   (near.empty() ? "; allowed are those of ScanNet and otherprop" : "; did you mean '" + near + "'?"));
}

std::vector<ClassTable::Row> rows_of(const std::filesystem::path& file, const YAML::Node& root) {
  if (!root.IsMap()) throw InputError(file.string() + ":1: not a map; allowed is CLASS: [NAME, ..] for each class");
  std::vector<ClassTable::Row> rows;
  for (const auto& pair : root) {
    const SemanticClass value = class_named(file, pair.first);
    if (!pair.second.IsSequence()) {
      throw InputError(yaml_place(file, pair.first) + pair.first.Scalar() + " is not a list of names");
    }
    for (const YAML::Node& item : pair.second) {
      if (!item.IsScalar() || item.Scalar().empty()) throw InputError(yaml_place(file, item) + "not a name");
      const auto same = [&](const ClassTable::Row& row) { return row.beginning == item.Scalar(); };
      if (std::any_of(rows.begin(), rows.end(), same)) {
        throw InputError(yaml_place(file, item) + "'" + item.Scalar() + "' is there twice; a name has one class");
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

ClassTable load_class_table(const std::filesystem::path& file) { return ClassTable(rows_of(file, load_yaml(file))); }

ClassTable class_table_beside(const World& world) {
  const std::filesystem::path file = world.file.parent_path() / "classes.yaml";
  return std::filesystem::exists(file) ? load_class_table(file) : ClassTable();
}

}  // namespace amiss::world
