#include "fuzz/seeds.hpp"
#include "semantics/forest.hpp"

namespace amiss::fuzz {

namespace {

semantics::ForestNode decision(std::uint8_t feature, float threshold, std::uint16_t right) {
  semantics::ForestNode node;
  node.feature = feature;
  node.threshold = threshold;
  node.right = right;
  return node;
}

semantics::ForestNode leaf(std::uint8_t place) {
  semantics::ForestNode node;
  node.shares[0] = {place, 200};
  node.shares[1] = {0, 55};
  return node;
}

}  // namespace

std::vector<std::string> valid_inputs() {
  semantics::Forest forest{0.02, {SemanticClass::kWall, SemanticClass::kFloor, SemanticClass::kTable}, {}};
  forest.trees = {{leaf(1)}};
  const std::string smallest = semantics::forest_bytes(forest);
  forest.trees.push_back({decision(0, 0.1F, 2), leaf(1), decision(177, -0.5F, 6), decision(3, 2.0F, 5), leaf(0), leaf(2),
                          leaf(2)});
  return {smallest, semantics::forest_bytes(forest)};
}

std::vector<std::string> words() {
  return {"amiss forest 1\n",          std::string("\x02\0", 2),     std::string("\xff\xff", 2),
          std::string(4, '\xff'),      std::string("\0\0\xc0\x7f", 4), std::string("\xb2\0", 2),
          std::string("\x01\0\0\0", 4)};
}

}  // namespace amiss::fuzz
