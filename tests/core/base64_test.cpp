#include "core/base64.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace amiss {
namespace {

TEST(Base64, IsThatOfRfc4648) {
  const std::vector<std::pair<std::string, std::string>> vectors{{"", ""},
                                                                 {"f", "Zg=="},
                                                                 {"fo", "Zm8="},
                                                                 {"foo", "Zm9v"},
                                                                 {"foob", "Zm9vYg=="},
                                                                 {"fooba", "Zm9vYmE="},
                                                                 {"foobar", "Zm9vYmFy"},
                                                                 {std::string("\xff\xfe\x00", 3), "//4A"}};
  for (const auto& [bytes, text] : vectors) EXPECT_EQ(base64(bytes), text);
  for (const auto& [bytes, text] : vectors) EXPECT_EQ(from_base64(text), bytes);
  EXPECT_EQ(from_base64("Zm9v\nYmFy"), "foo") << "up to what is no digit";
}

}  // namespace
}  // namespace amiss
