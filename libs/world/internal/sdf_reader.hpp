// SDF files -> trees, through libsdformat; each file is read once however often it is included.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "world/internal/model_tree.hpp"
#include "world/internal/resource_finder.hpp"
#include "world/internal/sdf_text.hpp"
#include "world/internal/shape_reader.hpp"

namespace amiss::world {

class SdfReader {
 public:
  SdfReader(const ResourceFinder& finder, int max_texture_px) : finder_(finder), shapes_(finder, max_texture_px) {}

  /// InputError where the file cannot be used; faults of included files are warnings.
  [[nodiscard]] FileTree read(const std::filesystem::path& file);
  /// Of everything read so far.
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  std::shared_ptr<const FileTree> read_include(const std::string& uri, const std::string& where,
                                               const std::filesystem::path& folder);

  const ResourceFinder& finder_;
  ShapeReader shapes_;
  std::map<std::filesystem::path, std::shared_ptr<const FileTree>> files_;
  std::vector<std::filesystem::path> open_;  // includes being read, to notice a file that includes itself
  std::vector<std::string> warnings_;
};

}  // namespace amiss::world
