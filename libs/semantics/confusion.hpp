// How often points of one class were labelled as another: counts, IoU of each class, and its file.
// in: true and labelled classes of the same points; points without a true class are left out     out: counts
// Files are TSV: `true` and the names of the labelled classes, then a row for each true class. Errors: InputError with
// file, line and what is allowed; ArgumentError where the two are not equally long.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "semantics/class_index.hpp"

namespace amiss::semantics {

class Confusion {
 public:
  void add(std::span<const SemanticClass> truth, std::span<const SemanticClass> labelled);
  void add(SemanticClass truth, SemanticClass labelled, std::uint64_t count);

  [[nodiscard]] std::uint64_t count(SemanticClass truth, SemanticClass labelled) const {
    return counts_[index_of(truth)][index_of(labelled)];
  }
  [[nodiscard]] std::uint64_t total() const;
  [[nodiscard]] std::uint64_t total_of(SemanticClass truth) const;
  /// Intersection over union; nothing for a class that is neither in the truth nor in the labels.
  [[nodiscard]] std::optional<double> iou(SemanticClass value) const;
  /// Over the classes that the truth has; 0 without any.
  [[nodiscard]] double mean_iou() const;
  [[nodiscard]] double accuracy() const;

  bool operator==(const Confusion&) const = default;

 private:
  std::array<std::array<std::uint64_t, kClassCount>, kClassCount> counts_{};
};

[[nodiscard]] std::string confusion_tsv(const Confusion& confusion);
[[nodiscard]] Confusion parse_confusion(const std::string& text, const std::string& name);
[[nodiscard]] Confusion load_confusion(const std::filesystem::path& file);
void save_confusion(const std::filesystem::path& file, const Confusion& confusion);

}  // namespace amiss::semantics
