// libFuzzer target: any bytes as a forest, also with the hash that they should have had, end with a forest whose every
// way down leads to a leaf and which is written again as it was, or with an InputError.
#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/files.hpp"
#include "core/result.hpp"
#include "semantics/forest.hpp"
#include "semantics/voxel_features.hpp"

namespace {

constexpr std::size_t kHashChars = 64;

void read(std::string_view bytes) {
  using namespace amiss::semantics;
  try {
    const Forest forest = parse_forest(bytes, "fuzz");
    for (const float value : {-1e9F, 0.0F, 1e9F}) {
      const std::vector<float> features(kFeatureCount, value);
      std::vector<float> probabilities(forest.classes.size());
      forest.classify(features, probabilities);
      for (const float p : probabilities) {
        if (!(p >= 0.0F && p <= 1.001F)) __builtin_trap();
      }
    }
    if (forest_bytes(forest) != bytes) __builtin_trap();
  } catch (const amiss::InputError&) {  // what bad input should end with
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes{reinterpret_cast<const char*>(data), size};
  read(bytes);
  const std::string body(bytes.substr(0, size - std::min(size, kHashChars)));
  read(body + amiss::sha256(body));
  return 0;
}
