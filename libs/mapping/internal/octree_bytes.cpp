#include "mapping/internal/octree_bytes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/result.hpp"
#include "mapping/internal/text.hpp"

namespace amiss::mapping {
namespace {

constexpr int kTreeDepth = 16;
constexpr int kBlockDepth = 13;  // nodes of 8 voxels edge
constexpr float kMaxLogOdds = 1000.0f;
constexpr std::string_view kOtMagic = "# Octomap OcTree file", kBtMagic = "# Octomap OcTree binary file";

/// One pass over the tree's bytes.
class Walk {
 public:
  Walk(std::string_view data, const OctreeHeader& header, const std::string& name,
       const std::function<void(const OctreeLeaf&)>* visit)
      : data_(data), header_(header), name_(name), visit_(visit) {}

  void run() {
    const Voxel low{-kVoxelLimit, -kVoxelLimit, -kVoxelLimit};
    if (header_.nodes > 0 && header_.binary) {
      ++nodes_;
      binary_node(low, 0);
    } else if (header_.nodes > 0) {
      plain_node(low, 0);
    }
    if (nodes_ != header_.nodes) {
      fail("holds " + std::to_string(nodes_) + " nodes where its header says " + std::to_string(header_.nodes));
    }
    if (at_ != data_.size()) fail("has " + std::to_string(data_.size() - at_) + " bytes left over behind the tree");
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(name_ + ": the octree " + what); }

  unsigned byte() {
    if (at_ >= data_.size()) fail("is cut short");
    return static_cast<unsigned char>(data_[at_++]);
  }
  float number() {
    std::uint32_t bits = 0;
    for (unsigned i = 0; i < 4; ++i) bits |= byte() << (8 * i);
    float value = 0.0f;
    std::memcpy(&value, &bits, sizeof value);
    if (!(std::abs(value) <= kMaxLogOdds)) fail("holds a log-odds that is not a number within +-1000");
    return value;
  }

  static Voxel child(Voxel low, int depth, unsigned i) {
    const int half = 1 << (kTreeDepth - 1 - depth);
    return {low.x + ((i & 1u) != 0 ? half : 0), low.y + ((i & 2u) != 0 ? half : 0), low.z + ((i & 4u) != 0 ? half : 0)};
  }

  void leaf(Voxel low, int depth, float log_odds) {
    const int edge = 1 << (kTreeDepth - depth);
    if (depth < kBlockDepth) {
      const std::size_t blocks = static_cast<std::size_t>(edge) / kBlockEdge;
      count_blocks(blocks * blocks * blocks);
    }
    if (visit_ != nullptr) (*visit_)(OctreeLeaf{low, edge, log_odds});
  }
  void count_blocks(std::size_t more) {
    blocks_ += more;
    if (blocks_ > kMaxBlocks) {
      fail("covers more than " + std::to_string(kMaxBlocks) + " cubes of 8 x 8 x 8 voxels, the most that is allowed");
    }
  }

  float plain_node(Voxel low, int depth) {
    ++nodes_;
    if (depth == kBlockDepth) count_blocks(1);
    const float value = number();
    const unsigned children = byte();
    if (children == 0) {
      leaf(low, depth, value);
      return value;
    }
    if (depth == kTreeDepth) fail("is deeper than 16 levels");
    float largest = -kMaxLogOdds;
    for (unsigned i = 0; i < 8; ++i) {
      if (((children >> i) & 1u) != 0) largest = std::max(largest, plain_node(child(low, depth, i), depth + 1));
    }
    // 0 stands in trees that were filled lazily and whose inner nodes were never brought up to date.
    if (value != largest && value != 0.0f) fail("has an inner node that is not the maximum of its children");
    return value == 0.0f ? largest : value;
  }

  void binary_node(Voxel low, int depth) {
    if (depth == kBlockDepth) count_blocks(1);
    const unsigned first = byte();
    const unsigned children = first | (byte() << 8);
    if (children == 0) fail("has an inner node without children");
    for (unsigned i = 0; i < 8; ++i) {
      const unsigned kind = (children >> (2 * i)) & 3u;
      if (kind != 0) binary_child(kind, child(low, depth, i), depth + 1);
    }
  }

  void binary_child(unsigned kind, Voxel low, int depth) {
    ++nodes_;
    if (kind == 3u) {
      if (depth == kTreeDepth) fail("is deeper than 16 levels");
      return binary_node(low, depth);
    }
    if (depth == kBlockDepth) count_blocks(1);
    leaf(low, depth, kind == 1u ? -1.0f : 1.0f);
  }

  std::string_view data_;
  const OctreeHeader& header_;
  const std::string& name_;
  const std::function<void(const OctreeLeaf&)>* visit_;
  std::size_t at_ = 0, nodes_ = 0, blocks_ = 0;
};

std::string_view take_line(std::string_view bytes, std::size_t& at) {
  const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
  std::string_view line = bytes.substr(at, end - at);
  at = std::min(end + 1, bytes.size());
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

/// A line "key value" of the header.
void read_header_line(std::string_view line, OctreeHeader& header, const std::string& name) {
  std::size_t at = 0;
  const std::string_view key = next_word(line, at), value = next_word(line, at);
  if (key == "id" && value != "OcTree") {
    throw InputError(name + ": a tree of type " + std::string(value.substr(0, 40)) + "; allowed is OcTree");
  }
  if (key == "size") {
    const auto size = parse_number<std::size_t>(value);
    if (!size) throw InputError(name + ": the header's size must be a number of nodes");
    header.nodes = *size;
  }
  if (key == "res") {
    const auto resolution = parse_number<double>(value);
    if (!resolution || !(*resolution >= 0.001 && *resolution <= 10.0)) {
      throw InputError(name + ": the header's res must be 0.001 to 10 m");
    }
    header.resolution_m = *resolution;
  }
}

}  // namespace

OctreeHeader read_octree_header(std::string_view bytes, const std::string& name) {
  OctreeHeader header;
  const std::string_view magic = take_line(bytes, header.data_at);
  header.binary = magic == kBtMagic;
  if (!header.binary && magic != kOtMagic) {
    throw InputError(name + ": not an OctoMap file; its first line must be \"" + std::string(kOtMagic) + "\" or \"" +
                     std::string(kBtMagic) + "\"");
  }
  bool sized = false, named = false;
  for (int lines = 0;; ++lines) {
    if (header.data_at >= bytes.size() || lines > 100) {
      throw InputError(name + ": the header is incomplete; id, size, res and data are needed");
    }
    const std::string_view line = take_line(bytes, header.data_at);
    if (line == "data") break;
    if (line.substr(0, 1) == "#") continue;
    read_header_line(line, header, name);
    sized = sized || line.substr(0, 5) == "size ";
    named = named || line.substr(0, 3) == "id ";
  }
  if (!sized || !named || header.resolution_m == 0.0) {
    throw InputError(name + ": the header is incomplete; id, size, res and data are needed");
  }
  // A node takes five bytes in .ot; in .bt two bytes describe up to eight nodes.
  const std::size_t data = bytes.size() - header.data_at;
  if (header.nodes > (header.binary ? 4 * data + 1 : data / 5)) {
    throw InputError(name + ": the header says " + std::to_string(header.nodes) +
                     " nodes, more than the file can hold");
  }
  return header;
}

void walk_octree(std::string_view bytes, const OctreeHeader& header, const std::string& name,
                 const std::function<void(const OctreeLeaf&)>& visit) {
  const std::string_view data = bytes.substr(header.data_at);
  Walk(data, header, name, nullptr).run();
  Walk(data, header, name, &visit).run();
}

}  // namespace amiss::mapping
