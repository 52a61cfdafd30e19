#include "world/loader.hpp"

#include <gtest/gtest.h>
TEST(X, Y) {
  const char* f = std::getenv("SDF");
  if (f == nullptr) GTEST_SKIP();
  const auto w = amiss::world::load_world(f, {{"/work/shared/data/ycb/models_light"}, 512});
  for (const auto& s : w.warnings) std::printf("W %s\n", s.c_str());
  std::printf("bodies %zu\n", w.bodies.size());
}
