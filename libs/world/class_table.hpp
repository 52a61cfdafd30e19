// Which semantic class the bodies of a world have: a table of names beside the world's file.
// In: classes.yaml, a map from class to the beginnings of names, e.g. `chair: [chair, stool]`: chair_dining_2 is a
// chair. Of two beginnings that fit the longer counts; a beginning ends where the name ends or goes on with _ or ::.
// Out: a class for each body, kUnlabelled where no beginning fits. Errors: InputError with file, line, what is wrong.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/semantic_class.hpp"
#include "world/world.hpp"

namespace amiss::world {

class ClassTable {
 public:
  struct Row {
    std::string beginning;
    SemanticClass value = SemanticClass::kUnlabelled;
  };
  ClassTable() = default;
  explicit ClassTable(std::vector<Row> rows) : rows_(std::move(rows)) {}

  [[nodiscard]] SemanticClass class_of(std::string_view body_name) const;
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

 private:
  std::vector<Row> rows_;
};

[[nodiscard]] ClassTable load_class_table(const std::filesystem::path& file);

/// The table `classes.yaml` beside the world's file; an empty one where there is none.
[[nodiscard]] ClassTable class_table_beside(const World& world);

}  // namespace amiss::world
