// Parameters are declared once: a stage's Params struct has its defaults in the members, and its describe() gives one
// row for a field. Reading YAML, overrides, range checks, printing and the record in run folders come from the rows.
//
//   struct Params { double resolution_m = 0.05; double fov_rad = radians(58); bool carve = true; };
//   void describe(ParamTable& table, Params& p) {
//     table.number("mapping.resolution", p.resolution_m, "m", 0.01, 0.5, "edge of a voxel (res)");
//     table.number("view.fov", p.fov_rad, "deg", 10, 120, "field of view (tr_angle)");   // stored in radians
//     table.flag("mapping.carve", p.carve, "rays free the space they cross");
//   }
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace amiss {

class ParamTable {
 public:
  /// unit "deg" means degrees in files and on the command line, radians in `value`; limits are in the unit of the file.
  void number(std::string key, double& value, std::string unit, double low, double high, std::string meaning);
  void integer(std::string key, int& value, int low, int high, std::string meaning);
  void flag(std::string key, bool& value, std::string meaning);
  void choice(std::string key, std::string& value, std::vector<std::string> allowed, std::string meaning);

  /// Set one key from text; `where` starts the sentence of the ArgumentError. Unknown keys (with the nearest known
  /// one), NaN and values out of range are errors.
  void set(std::string_view key, std::string_view text, std::string_view where);
  /// "key=value" of the command line.
  void set_override(std::string_view assignment);
  /// Nested YAML maps; keys joined by dots. InputError when unreadable, ArgumentError naming file:line otherwise.
  void load_file(const std::filesystem::path& file);
  /// All rows as YAML that load_file reads back, with unit, range and meaning as comments.
  [[nodiscard]] std::string to_yaml() const;

  struct Row {
    std::string key, unit, allowed, meaning;
    std::function<std::string()> print;
    std::function<bool(std::string_view)> parse;  // false: not allowed, nothing changed
  };
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

 private:
  std::vector<Row> rows_;
};

/// The candidate that is nearest to `word` by edit distance, or "" where none is near.
[[nodiscard]] std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace amiss
