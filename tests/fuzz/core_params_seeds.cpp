#include "fuzz/seeds.hpp"

namespace amiss::fuzz {

std::vector<std::string> valid_inputs() {
  return {"map:\n  length: 0.1\n  angle: 58  # degrees\nview: {count: 5}\n", "map.length: 0.2\nview.count: 1\n"};
}

std::vector<std::string> words() {
  return {"map", "view.count", ": ", "&a ", "*a", "{", "}", "- ", "? ", "<<", ".nan"};
}

}  // namespace amiss::fuzz
