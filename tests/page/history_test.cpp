#include "page/history.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace amiss::page {
namespace {

TEST(History, ReadsInBatchesThatFit) {
  History history;
  for (const char* line : {"one", "two", "a line that is longer than a batch", "four"}) history.append(line);
  const auto first = history.read(0, 8);
  EXPECT_EQ(first.text, "one\ntwo\n");
  const auto second = history.read(first.next, 8);
  EXPECT_EQ(second.text, "a line that is longer than a batch\n") << "at least one line";
  const auto third = history.read(second.next, 8);
  EXPECT_EQ(third.text, "four\n");
  const auto nothing = history.read(third.next, 8);
  EXPECT_EQ(nothing.text, "");
  EXPECT_EQ(nothing.next, 4U);
  EXPECT_EQ(history.lines().size(), 4U);
}

TEST(History, TellsItsListener) {
  History history;
  int told = 0;
  history.set_listener([&] { ++told; });
  history.append("a");
  history.append("b");
  history.set_listener({});
  history.append("c");
  EXPECT_EQ(told, 2);
}

TEST(History, ReadersSeeEveryLineOnceAndInOrder) {
  History history;
  constexpr std::size_t kLines = 5000;
  std::thread writer([&] {
    for (std::size_t i = 0; i < kLines; ++i) history.append(std::to_string(i));
  });
  std::string seen, expected;
  for (std::size_t at = 0; at < kLines;) {
    auto batch = history.read(at, 256);
    seen += batch.text;
    at = batch.next;
  }
  writer.join();
  for (std::size_t i = 0; i < kLines; ++i) expected += std::to_string(i) + "\n";
  EXPECT_EQ(seen, expected);
}

}  // namespace
}  // namespace amiss::page
