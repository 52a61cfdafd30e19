#include "fuzz/seeds.hpp"

namespace amiss::fuzz {

std::vector<std::string> valid_inputs() {
  std::string seed =
      "image: map.pgm\nresolution: 0.05\norigin: [-1.0, -2.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\n"
      "free_thresh: 0.196\n";
  seed += '\0';
  seed += "P5\n# a comment\n8 6\n255\n";
  for (int i = 0; i < 48; ++i) seed += static_cast<char>(i % 3 == 0 ? 0 : i % 3 == 1 ? 205 : 254);
  return {seed};
}

std::vector<std::string> words() {
  return {"P5", "P2", "65535", "resolution: ", "origin: [", "negate: 1", "mode: raw"};
}

}  // namespace amiss::fuzz
