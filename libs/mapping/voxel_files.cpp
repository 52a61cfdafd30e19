#include "mapping/voxel_files.hpp"

#include <octomap/octomap.h>

#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "core/files.hpp"
#include "core/result.hpp"
#include "mapping/internal/octree_bytes.hpp"

namespace amiss::mapping {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{1} << 28;

octomap::OcTree octree_of(const VoxelMap& map) {
  const auto probability = [](double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); };
  octomap::OcTree tree(map.resolution_m());
  tree.setClampingThresMin(probability(map.params().clamp_low));
  tree.setClampingThresMax(probability(map.params().clamp_high));
  map.for_each_known([&](Voxel v, Occupancy) {
    const auto key = [](int i) { return static_cast<octomap::key_type>(i + kVoxelLimit); };
    tree.setNodeValue(octomap::OcTreeKey(key(v.x), key(v.y), key(v.z)), static_cast<float>(map.log_odds(v)), true);
  });
  tree.updateInnerOccupancy();
  tree.prune();
  return tree;
}

}  // namespace

VoxelMap parse_voxel_map(std::string_view bytes, const std::string& name, const VoxelMapParams& params) {
  const OctreeHeader header = read_octree_header(bytes, name);
  VoxelMapParams with_resolution = params;
  with_resolution.resolution_m = header.resolution_m;
  VoxelMap map(with_resolution);
  walk_octree(bytes, header, name, [&](const OctreeLeaf& leaf) {
    const double occupied = header.binary ? params.clamp_high : double{leaf.log_odds};
    const double log_odds = header.binary && leaf.log_odds < 0.0f ? params.clamp_low : occupied;
    for (int z = 0; z < leaf.edge; ++z) {
      for (int y = 0; y < leaf.edge; ++y) {
        for (int x = 0; x < leaf.edge; ++x) {
          map.set_log_odds({leaf.low.x + x, leaf.low.y + y, leaf.low.z + z}, log_odds);
        }
      }
    }
  });
  return map;
}

VoxelMap load_voxel_map(const std::filesystem::path& file, const VoxelMapParams& params) {
  return parse_voxel_map(load_bytes(file, kMaxFileBytes), file.string(), params);
}

std::string voxel_map_bytes(const VoxelMap& map, VoxelFormat format) {
  octomap::OcTree tree = octree_of(map);
  std::ostringstream out;
  out.imbue(std::locale::classic());
  const bool binary = format == VoxelFormat::kBt;
  if (binary) {
    tree.toMaxLikelihood();
    tree.prune();
  }
  // As OctoMap's write and writeBinary do it, which print besides.
  out << "# Octomap OcTree " << (binary ? "binary " : "")
      << "file\n# (feel free to add / change comments, but leave the first line as it is!)\n#\nid "
      << tree.getTreeType() << "\nsize " << tree.size() << "\nres " << tree.getResolution() << "\ndata\n";
  if (binary) {
    tree.writeBinaryData(out);
  } else {
    tree.writeData(out);
  }
  if (!out) throw std::runtime_error("octree: OctoMap could not write it");
  return out.str();
}

void save_voxel_map(const std::filesystem::path& file, const VoxelMap& map) {
  const std::string extension = file.extension().string();
  if (extension != ".ot" && extension != ".bt") {
    throw ArgumentError(file.string() + ": the extension of an OctoMap file must be .ot or .bt");
  }
  save_atomically(file, voxel_map_bytes(map, extension == ".ot" ? VoxelFormat::kOt : VoxelFormat::kBt));
}

}  // namespace amiss::mapping
