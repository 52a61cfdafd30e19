// Random streams that are equal on every machine: seeded from the run's seed and the name of their use.
#pragma once

#include <cstdint>
#include <string_view>

namespace amiss {

/// xoshiro256** (Blackman and Vigna 2018), seeded by splitmix64 of seed and name.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view name);

  std::uint64_t next();
  double uniform();                                         // [0, 1)
  double uniform(double low, double high);                  // [low, high)
  std::uint64_t below(std::uint64_t limit);                 // 0 .. limit-1, limit > 0, unbiased
  double normal();                                          // mean 0, standard deviation 1 (polar method)
  [[nodiscard]] RandomStream child(std::string_view name);  // an independent stream

  // UniformRandomBitGenerator
  using result_type = std::uint64_t;
  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return ~result_type{0}; }
  result_type operator()() { return next(); }

 private:
  std::uint64_t state_[4];
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace amiss
