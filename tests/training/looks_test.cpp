#include "training/looks.hpp"

#include <gtest/gtest.h>

namespace amiss::training {
namespace {

double mean_green_over_red(const world::Material& material) {
  double red = 0, green = 0;
  for (const Rgb& pixel : material.texture->pixels) {
    red += pixel.r;
    green += pixel.g;
  }
  return green / red;
}

TEST(Looks, AllHaveATexture) {
  RandomStream random(1, "looks");
  for (const auto make : {random_wood, random_fabric, random_paint, random_plastic, random_dark, random_leaf,
                          random_print, random_board}) {
    const world::Material look = make(random);
    ASSERT_NE(look.texture, nullptr);
    EXPECT_EQ(look.texture->pixels.size(),
              static_cast<std::size_t>(look.texture->width) * static_cast<std::size_t>(look.texture->height));
    EXPECT_FLOAT_EQ(look.alpha, 1.0F);
  }
}

TEST(Looks, WoodIsBrownAndLeavesAreGreen) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomStream random(seed, "looks");
    EXPECT_LT(mean_green_over_red(random_wood(random)), 1.0);
    EXPECT_GT(mean_green_over_red(random_leaf(random)), 1.0);
  }
}

TEST(Looks, OneStreamOneLook) {
  RandomStream a(5, "looks"), b(5, "looks"), c(6, "looks");
  EXPECT_EQ(random_print(a).texture->pixels, random_print(b).texture->pixels);
  EXPECT_NE(random_print(a).texture->pixels, random_print(c).texture->pixels);
}

}  // namespace
}  // namespace amiss::training
