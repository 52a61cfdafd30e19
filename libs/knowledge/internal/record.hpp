// The SQLite file behind the knowledge base.
#pragma once

#include <filesystem>
#include <memory>

#include "knowledge/knowledge_base.hpp"

namespace amiss::knowledge::internal {

class Record {
 public:
  /// Opens or creates. InputError in one sentence where that fails.
  explicit Record(const std::filesystem::path& file);
  ~Record();
  Record(const Record&) = delete;
  Record& operator=(const Record&) = delete;

  /// Everything in the file; InputError where it does not hold together.
  [[nodiscard]] Knowledge load();

  /// Writes these rows, new or again, in one transaction. std::runtime_error where the file cannot be written.
  void save(const std::vector<Region>& regions, const std::vector<View>& views, const std::vector<Object>& objects);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace amiss::knowledge::internal
