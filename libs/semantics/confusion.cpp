#include "semantics/confusion.hpp"

#include <charconv>
#include <numeric>
#include <sstream>
#include <vector>

#include "core/files.hpp"
#include "core/result.hpp"

namespace amiss::semantics {

namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, '\t');) cells.push_back(cell);
  return cells;
}

SemanticClass class_named(const std::string& cell, const std::string& where) {
  const auto value = semantic_class_of(cell);
  if (!value) throw InputError(where + ": '" + cell + "' is no class; the names of ScanNet's classes are allowed");
  return *value;
}

std::uint64_t count_in(const std::string& cell, const std::string& where) {
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), count);
  if (error != std::errc() || end != cell.data() + cell.size()) {
    throw InputError(where + ": '" + cell + "' is no count; whole numbers from 0 on are allowed");
  }
  return count;
}

}  // namespace

void Confusion::add(std::span<const SemanticClass> truth, std::span<const SemanticClass> labelled) {
  if (truth.size() != labelled.size()) throw ArgumentError("confusion: as many labels as true classes are needed");
  for (std::size_t i = 0; i < truth.size(); ++i) add(truth[i], labelled[i], 1);
}

void Confusion::add(SemanticClass truth, SemanticClass labelled, std::uint64_t count) {
  if (truth != SemanticClass::kUnlabelled) counts_[index_of(truth)][index_of(labelled)] += count;
}

std::uint64_t Confusion::total_of(SemanticClass truth) const {
  const auto& row = counts_[index_of(truth)];
  return std::accumulate(row.begin(), row.end(), std::uint64_t{0});
}

std::uint64_t Confusion::total() const {
  std::uint64_t sum = 0;
  for (const NamedSemanticClass& c : kSemanticClasses) sum += total_of(c.value);
  return sum;
}

std::optional<double> Confusion::iou(SemanticClass value) const {
  std::uint64_t labelled = 0;
  for (const auto& row : counts_) labelled += row[index_of(value)];
  const std::uint64_t both = count(value, value), either = labelled + total_of(value) - both;
  if (either == 0) return std::nullopt;
  return static_cast<double>(both) / static_cast<double>(either);
}

double Confusion::mean_iou() const {
  double sum = 0;
  int classes = 0;
  for (const NamedSemanticClass& c : kSemanticClasses) {
    if (total_of(c.value) == 0) continue;
    sum += iou(c.value).value_or(0.0);
    ++classes;
  }
  return classes == 0 ? 0.0 : sum / classes;
}

double Confusion::accuracy() const {
  std::uint64_t right = 0;
  for (std::size_t i = 0; i < kClassCount; ++i) right += counts_[i][i];
  const std::uint64_t all = total();
  return all == 0 ? 0.0 : static_cast<double>(right) / static_cast<double>(all);
}

std::string confusion_tsv(const Confusion& confusion) {
  std::string text = "true";
  for (const NamedSemanticClass& c : kSemanticClasses) text += '\t' + std::string(c.name);
  for (const NamedSemanticClass& truth : kSemanticClasses) {
    if (truth.value == SemanticClass::kUnlabelled) continue;
    text += '\n' + std::string(truth.name);
    for (const NamedSemanticClass& c : kSemanticClasses) {
      text += '\t' + std::to_string(confusion.count(truth.value, c.value));
    }
  }
  return text + '\n';
}

Confusion parse_confusion(const std::string& text, const std::string& name) {
  Confusion confusion;
  std::vector<SemanticClass> columns;
  std::istringstream stream(text);
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    const std::string where = name + ":" + std::to_string(++number);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) continue;
    const std::vector<std::string> cells = cells_of(line);
    if (columns.empty()) {
      if (cells.size() < 2 || cells[0] != "true") throw InputError(where + ": 'true' and names of classes are needed");
      for (std::size_t i = 1; i < cells.size(); ++i) columns.push_back(class_named(cells[i], where));
      continue;
    }
    if (cells.size() != columns.size() + 1) {
      throw InputError(where + ": " + std::to_string(cells.size()) + " cells; a class and " +
                       std::to_string(columns.size()) + " counts are needed");
    }
    const SemanticClass truth = class_named(cells[0], where);
    for (std::size_t i = 0; i < columns.size(); ++i) confusion.add(truth, columns[i], count_in(cells[i + 1], where));
  }
  if (confusion.total() == 0) throw InputError(name + ": no counts; a table of true and labelled classes is needed");
  return confusion;
}

Confusion load_confusion(const std::filesystem::path& file) { return parse_confusion(load_bytes(file), file.string()); }

void save_confusion(const std::filesystem::path& file, const Confusion& confusion) {
  save_atomically(file, confusion_tsv(confusion));
}

}  // namespace amiss::semantics
