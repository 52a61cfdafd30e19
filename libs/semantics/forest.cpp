#include "semantics/forest.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/files.hpp"
#include "core/result.hpp"
#include "semantics/class_index.hpp"
#include "semantics/voxel_features.hpp"

namespace amiss::semantics {

namespace {

constexpr std::string_view kMagic = "amiss forest 1\n";
constexpr std::size_t kHashChars = 64, kMaxTrees = 1000;
static_assert(std::endian::native == std::endian::little);
static_assert(kFeatureCount < ForestNode::kLeaf);

template <class T>
void put(std::string& bytes, T value) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), &value, sizeof(T));
  bytes.append(raw.data(), raw.size());
}

/// Takes numbers off the front; InputError where there are none left.
class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  template <class T>
  T take() {
    if (bytes_.size() < sizeof(T)) fail("ends too early");
    T value;
    std::memcpy(&value, bytes_.data(), sizeof(T));
    bytes_.remove_prefix(sizeof(T));
    return value;
  }
  [[nodiscard]] bool at_end() const { return bytes_.empty(); }
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(name_ + ": " + what + "; a forest written by 'amiss semantics train' is needed");
  }

 private:
  std::string_view bytes_;
  const std::string& name_;
};

void put_node(std::string& bytes, const ForestNode& node) {
  put(bytes, node.feature);
  if (node.feature != ForestNode::kLeaf) {
    put(bytes, node.threshold);
    put(bytes, node.right);
    return;
  }
  for (const ForestNode::Share& share : node.shares) {
    put(bytes, share.place);
    put(bytes, share.weight);
  }
}

ForestNode take_node(Reader& reader, std::size_t classes) {
  ForestNode node;
  node.feature = reader.take<std::uint8_t>();
  if (node.feature != ForestNode::kLeaf) {
    node.threshold = reader.take<float>();
    node.right = reader.take<std::uint16_t>();
    if (node.feature >= kFeatureCount || !std::isfinite(node.threshold)) reader.fail("holds an impossible decision");
    return node;
  }
  for (ForestNode::Share& share : node.shares) {
    share.place = reader.take<std::uint8_t>();
    share.weight = reader.take<std::uint8_t>();
    if (share.place >= classes) reader.fail("holds a leaf of an unknown class");
  }
  return node;
}

/// The way down always leads on to a later node and ends at a leaf.
void check_tree(const std::vector<ForestNode>& tree, const Reader& reader) {
  for (std::size_t i = 0; i < tree.size(); ++i) {
    if (tree[i].feature == ForestNode::kLeaf) continue;
    if (tree[i].right <= i + 1 || tree[i].right >= tree.size()) reader.fail("holds a tree that leads nowhere");
  }
  if (tree.empty() || tree.back().feature != ForestNode::kLeaf) reader.fail("holds a tree without an end");
}

const ForestNode& leaf_of(const std::vector<ForestNode>& tree, std::span<const float> features) {
  std::size_t at = 0;
  while (tree[at].feature != ForestNode::kLeaf) {
    at = features[tree[at].feature] <= tree[at].threshold ? at + 1 : tree[at].right;
  }
  return tree[at];
}

}  // namespace

void Forest::classify(std::span<const float> features, std::span<float> probabilities) const {
  std::fill(probabilities.begin(), probabilities.end(), 0.0F);
  float sum = 0;
  for (const std::vector<ForestNode>& tree : trees) {
    for (const ForestNode::Share& share : leaf_of(tree, features).shares) {
      probabilities[share.place] += static_cast<float>(share.weight);
      sum += static_cast<float>(share.weight);
    }
  }
  if (sum > 0) {
    for (float& p : probabilities) p /= sum;
  }
}

std::string forest_bytes(const Forest& forest) {
  std::string bytes(kMagic);
  put(bytes, forest.voxel_m);
  put(bytes, static_cast<std::uint16_t>(kFeatureCount));
  put(bytes, static_cast<std::uint8_t>(forest.classes.size()));
  for (const SemanticClass c : forest.classes) put(bytes, static_cast<std::uint8_t>(c));
  put(bytes, static_cast<std::uint32_t>(forest.trees.size()));
  for (const std::vector<ForestNode>& tree : forest.trees) {
    put(bytes, static_cast<std::uint32_t>(tree.size()));
    for (const ForestNode& node : tree) put_node(bytes, node);
  }
  return bytes + sha256(bytes);
}

Forest parse_forest(std::string_view bytes, const std::string& name) {
  Reader front(bytes, name);
  if (!bytes.starts_with(kMagic)) front.fail("is no forest");
  if (bytes.size() < kMagic.size() + kHashChars) front.fail("ends too early");
  const std::string_view body = bytes.substr(0, bytes.size() - kHashChars);
  if (sha256(body) != bytes.substr(body.size())) front.fail("is damaged or cut (its hash does not fit)");
  Reader reader(body.substr(kMagic.size()), name);
  Forest forest;
  forest.voxel_m = reader.take<double>();
  if (!(forest.voxel_m >= 0.005 && forest.voxel_m <= 0.1)) reader.fail("is for voxels of an impossible size");
  if (reader.take<std::uint16_t>() != kFeatureCount) reader.fail("is of another version of amiss (other features)");
  forest.classes.resize(reader.take<std::uint8_t>());
  for (SemanticClass& c : forest.classes) {
    c = static_cast<SemanticClass>(reader.take<std::uint8_t>());
    if (index_of(c) == 0) reader.fail("knows a class that does not exist");
  }
  const auto trees = reader.take<std::uint32_t>();
  if (trees == 0 || trees > kMaxTrees || forest.classes.empty()) reader.fail("has no trees or classes, or too many");
  for (std::uint32_t t = 0; t < trees; ++t) {
    const auto nodes = reader.take<std::uint32_t>();
    std::vector<ForestNode>& tree = forest.trees.emplace_back();
    for (std::uint32_t n = 0; n < nodes; ++n) tree.push_back(take_node(reader, forest.classes.size()));
    check_tree(tree, reader);
  }
  if (!reader.at_end()) reader.fail("goes on behind its end");
  return forest;
}

Forest load_forest(const std::filesystem::path& file) {
  return parse_forest(load_bytes(file, std::size_t{1} << 28), file.string());
}

void save_forest(const std::filesystem::path& file, const Forest& forest) {
  save_atomically(file, forest_bytes(forest));
}

}  // namespace amiss::semantics
