// In which order to visit places: the shortest open tour from a start over all of them.
// Matrix of way lengths, place 0 is the start -> order of the others and the length. Nearest neighbour, then 2-opt and
// Or-opt until nothing improves (Croes 1958, Or 1976), from several beginnings.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace amiss::motion {

struct Tour {
  std::vector<std::size_t> order;  // places 1 .. n-1, each once; unreachable ones at the end
  double length_m = 0.0;           // of the reachable part; infinite when every order has a link without a way
  std::size_t reachable = 0;       // how many of the order can be reached
};

/// `lengths_m`: row-major n x n, symmetric, not negative, infinite where there is no way. ArgumentError when it is not
/// square, and for n = 0.
[[nodiscard]] Tour shortest_tour(std::span<const double> lengths_m, std::size_t n);

}  // namespace amiss::motion
