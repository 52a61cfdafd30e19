// Some hundred mutations of valid inputs through one fuzz target; it traps or crashes when one of them is not refused
// properly.
#include <gtest/gtest.h>

#include <cstdint>

#include "core/random.hpp"
#include "fuzz/seeds.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace amiss::fuzz {
namespace {

constexpr int kMutations = 1000;  // of each seed

void feed(const std::string& bytes) {
  EXPECT_EQ(LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), 0);
}

const std::vector<std::string>& all_words() {
  static const std::vector<std::string> list = [] {
    std::vector<std::string> words = fuzz::words();
    for (const char* word : {"nan", "-inf", "1e999", "-1", "0", "99999999999999999999", "\xff\xfe", "\n", " "}) {
      words.emplace_back(word);
    }
    words.emplace_back(1, '\0');
    words.emplace_back(5000, '(');
    return words;
  }();
  return list;
}

std::string mutated(std::string bytes, RandomStream& random) {
  for (std::uint64_t i = 1 + random.below(4); i > 0; --i) {
    const std::size_t at = random.below(bytes.size() + 1);
    const std::size_t length = random.below(1 + std::min<std::size_t>(40, bytes.size() - at));
    switch (random.below(6)) {
      case 0:
        if (at < bytes.size())
          bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ 1U << random.below(8));
        break;
      case 1:
        bytes.erase(at, length);
        break;
      case 2:
        bytes.insert(at, bytes.substr(at, length));
        break;
      case 3:
        bytes.insert(at, all_words()[random.below(all_words().size())]);
        break;
      case 4:
        bytes.replace(at, length, all_words()[random.below(all_words().size())]);
        break;
      default:
        bytes.resize(random.below(4) == 0 ? at : bytes.size());
    }
  }
  return bytes;
}

TEST(Fuzz, ValidInputs) {
  for (const std::string& seed : valid_inputs()) feed(seed);
}

TEST(Fuzz, NothingZeroAndNoise) {
  feed("");
  feed(std::string(1000, '\0'));
  RandomStream random(1, "noise");
  for (int i = 0; i < 20; ++i) {
    std::string noise(random.below(3000), ' ');
    for (char& c : noise) c = static_cast<char>(random.below(256));
    feed(noise);
  }
}

TEST(Fuzz, CutShort) {
  for (const std::string& seed : valid_inputs()) {
    for (std::size_t part = 0; part < 40; ++part) feed(seed.substr(0, seed.size() * part / 40));
  }
}

TEST(Fuzz, Mutations) {
  RandomStream random(1, "mutations");
  for (const std::string& seed : valid_inputs()) {
    for (int i = 0; i < kMutations; ++i) feed(mutated(seed, random));
  }
}

}  // namespace
}  // namespace amiss::fuzz
