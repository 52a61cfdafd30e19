// Ground truth of a recording, pixel by pixel: which body each pixel shows, and what these bodies are.
// The folder `truth` of a recording has instances/<time>.png (one channel of 16 bits: the number of the body, 0 for
// none), the list instances.txt ("time file", as rgb.txt) and the table instances.tsv.
// Errors: InputError naming file and line; std::runtime_error when writing fails.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/semantic_class.hpp"
#include "core/stamp.hpp"

namespace amiss::dataset {

/// A row of instances.tsv.
struct Instance {
  std::uint16_t number = 0;
  std::string name;  // unique in the recording
  std::string kind;  // of a placed object, its name in the catalogue; empty for all that belongs to the place
  SemanticClass value = SemanticClass::kUnlabelled;
  bool on_floor = false;  // of a placed object
};
void save_instances(const std::filesystem::path& file, const std::vector<Instance>& instances);
[[nodiscard]] std::vector<Instance> load_instances(const std::filesystem::path& file);

class InstanceWriter {
 public:
  explicit InstanceWriter(std::filesystem::path folder);
  void add(Stamp stamp, int width, int height, const std::vector<std::uint16_t>& numbers);
  void finish() const;

 private:
  std::filesystem::path folder_;
  std::string list_;
};

class InstanceImages {
 public:
  explicit InstanceImages(const std::filesystem::path& folder);
  [[nodiscard]] std::size_t size() const { return files_.size(); }
  /// Of the frame of this time; nothing where there is none.
  [[nodiscard]] std::optional<std::vector<std::uint16_t>> load(Stamp stamp) const;

 private:
  std::map<Stamp, std::filesystem::path> files_;
};

}  // namespace amiss::dataset
