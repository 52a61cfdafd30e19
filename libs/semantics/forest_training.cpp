#include "semantics/forest_training.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/ml.hpp>

#include "core/random.hpp"
#include "core/result.hpp"
#include "semantics/parallel.hpp"
#include "semantics/voxel_features.hpp"

namespace amiss::semantics {

namespace {

constexpr int kDeepest = 24;

/// The samples of each class, and how often a class is drawn.
struct Pool {
  const ForestSamples& samples;
  std::vector<SemanticClass> classes;
  std::vector<std::uint8_t> place;  // of each sample's class in classes
  std::vector<std::vector<std::uint32_t>> members;
  std::vector<double> weights, shares;  // of a class; running sum of it

  explicit Pool(const ForestSamples& s) : samples(s) {
    std::map<SemanticClass, std::uint8_t> places;
    for (const SemanticClass c : s.classes) places.emplace(c, std::uint8_t{0});
    for (auto& [value, at] : places) {
      at = static_cast<std::uint8_t>(classes.size());
      classes.push_back(value);
    }
    members.resize(classes.size());
    for (std::size_t i = 0; i < s.classes.size(); ++i) {
      place.push_back(places.at(s.classes[i]));
      members[place.back()].push_back(static_cast<std::uint32_t>(i));
    }
    double sum = 0;
    for (const auto& of_class : members) {
      weights.push_back(std::sqrt(static_cast<double>(of_class.size())));
      shares.push_back(sum += weights.back());
    }
  }
  [[nodiscard]] std::span<const float> features(std::uint32_t sample) const {
    return std::span(samples.features).subspan(sample * kFeatureCount, kFeatureCount);
  }
  [[nodiscard]] std::uint32_t draw(RandomStream& random) const {
    const double at = random.uniform() * shares.back();
    const auto found = std::upper_bound(shares.begin(), shares.end(), at);
    const auto c = std::min<std::size_t>(static_cast<std::size_t>(found - shares.begin()), shares.size() - 1);
    return members[c][random.below(members[c].size())];
  }
};

cv::Ptr<cv::ml::RTrees> grow(const Pool& pool, const ForestTrainingParams& params, RandomStream& random) {
  cv::Mat features(params.draws, static_cast<int>(kFeatureCount), CV_32F), classes(params.draws, 1, CV_32S);
  for (int i = 0; i < params.draws; ++i) {
    const std::uint32_t sample = pool.draw(random);
    std::ranges::copy(pool.features(sample), features.ptr<float>(i));
    classes.at<int>(i) = pool.place[sample];
  }
  const auto forest = cv::ml::RTrees::create();
  forest->setMaxDepth(params.depth);
  forest->setMinSampleCount(params.fewest_in_node);
  forest->setActiveVarCount(params.features_of_a_split);
  forest->setTermCriteria({cv::TermCriteria::MAX_ITER, 1, 0.0});
  cv::theRNG().state = random.next();  // of this thread; it draws the features of the splits
  forest->train(cv::ml::TrainData::create(features, cv::ml::ROW_SAMPLE, classes));
  return forest;
}

/// OpenCV's nodes in the order in which a forest of ours keeps them: a node, all that is left of it, all right of it.
class Copy {
 public:
  explicit Copy(const cv::ml::RTrees& trees) : nodes_(trees.getNodes()), splits_(trees.getSplits()) {
    add(trees.getRoots().front());
  }
  [[nodiscard]] std::vector<ForestNode> take() { return std::move(tree_); }

 private:
  void add(int from) {
    const cv::ml::DTrees::Node& node = nodes_[static_cast<std::size_t>(from)];
    const std::size_t at = tree_.size();
    tree_.emplace_back();
    if (node.split < 0) return;
    const cv::ml::DTrees::Split& split = splits_[static_cast<std::size_t>(node.split)];
    tree_[at].feature = static_cast<std::uint8_t>(split.varIdx);
    tree_[at].threshold = split.c;
    add(node.left);
    if (tree_.size() > std::numeric_limits<std::uint16_t>::max()) {
      throw ArgumentError("a tree of the forest grew too large; fewer draws or a lower depth are needed");
    }
    tree_[at].right = static_cast<std::uint16_t>(tree_.size());
    add(node.right);
  }

  const std::vector<cv::ml::DTrees::Node>& nodes_;
  const std::vector<cv::ml::DTrees::Split>& splits_;
  std::vector<ForestNode> tree_;
};

/// The three heaviest classes of each leaf.
void fill_leaves(std::vector<ForestNode>& tree, const Pool& pool) {
  std::vector<std::vector<double>> heaps(tree.size());
  for (std::uint32_t i = 0; i < pool.place.size(); ++i) {
    std::size_t at = 0;
    const auto features = pool.features(i);
    while (tree[at].feature != ForestNode::kLeaf) {
      at = features[tree[at].feature] <= tree[at].threshold ? at + 1 : tree[at].right;
    }
    heaps[at].resize(pool.classes.size());
    const std::uint8_t c = pool.place[i];
    heaps[at][c] += pool.weights[c] / static_cast<double>(pool.members[c].size());
  }
  for (std::size_t n = 0; n < tree.size(); ++n) {
    double sum = 0;
    for (const double weight : heaps[n]) sum += weight;
    for (ForestNode::Share& share : tree[n].shares) {
      const auto most = std::max_element(heaps[n].begin(), heaps[n].end());
      if (most == heaps[n].end() || *most <= 0) break;
      share.place = static_cast<std::uint8_t>(most - heaps[n].begin());
      share.weight = static_cast<std::uint8_t>(std::lround(255.0 * *most / sum));
      *most = 0;
    }
  }
}

void check(const ForestSamples& samples, const ForestTrainingParams& p) {
  if (samples.features.size() != samples.classes.size() * kFeatureCount) {
    throw ArgumentError("training of a forest: " + std::to_string(kFeatureCount) + " features a sample are needed");
  }
  if (p.trees < 1 || p.draws < 10 || p.depth < 1 || p.depth > kDeepest || p.fewest_in_node < 1 ||
      p.features_of_a_split < 1 || p.features_of_a_split > static_cast<int>(kFeatureCount)) {
    throw ArgumentError("training of a forest: 1 tree, 10 draws, a depth of 1 .. " + std::to_string(kDeepest) +
                        ", 1 sample in a node and 1 .. " + std::to_string(kFeatureCount) +
                        " features of a split are the least");
  }
}

}  // namespace

Forest train_forest(const ForestSamples& samples, const ForestTrainingParams& params, double voxel_m,
                    std::uint64_t seed, int threads) {
  check(samples, params);
  const Pool pool(samples);
  if (pool.classes.size() < 2) throw ArgumentError("training of a forest: samples of two classes or more are needed");
  Forest forest{voxel_m, pool.classes, {}};
  forest.trees.resize(static_cast<std::size_t>(params.trees));
  in_parallel(forest.trees.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      RandomStream random(seed, "semantics/tree " + std::to_string(t));
      std::vector<ForestNode>& tree = forest.trees[t];
      tree = Copy(*grow(pool, params, random)).take();
      fill_leaves(tree, pool);
    }
  });
  return forest;
}

}  // namespace amiss::semantics
