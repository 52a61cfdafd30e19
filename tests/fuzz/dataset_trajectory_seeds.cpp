#include "fuzz/seeds.hpp"

namespace amiss::fuzz {

std::vector<std::string> valid_inputs() {
  return {"# t x y z qx qy qz qw\n1.5 1 2 3 0 0 0 1\n1.6 1 2 3 0 0.6 0 0.8\n",
          "0 0 1\n0 -1 0 1\n1 0 0 2\n0 0 1 3\n0 0 0 1\n1 1 2\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n",
          "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"};
}

std::vector<std::string> words() { return {"9000000001", "1e308", "0.0000000001", "# ", "-0", "\r\n", "+1"}; }

}  // namespace amiss::fuzz
