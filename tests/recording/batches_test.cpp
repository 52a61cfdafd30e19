// Nothing is lost, the order stays, and no more than one batch waits.
#include "recording/batches.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace amiss::recording {
namespace {

TEST(Batches, EverythingIsWrittenInItsOrderByAnyNumberOfThreads) {
  for (const bool threaded : {false, true}) {
    std::vector<std::vector<int>> written, expected;
    {
      Batches<int> batches([&](const std::vector<int>& batch) { written.push_back(batch); }, threaded);
      for (int i = 0; i < 100; ++i) {
        expected.emplace_back();
        for (int k = 0; k <= i % 7; ++k) {
          batches.add(100 * i + k);
          expected.back().push_back(100 * i + k);
        }
        batches.hand_over();
        batches.hand_over();  // nothing was gathered: nothing is written
      }
    }
    EXPECT_EQ(written, expected) << threaded;
  }
}

TEST(Batches, ASlowWriterHoldsUpTheBatchAfterTheNext) {
  std::atomic<int> written = 0;
  Batches<int> batches(
      [&](const std::vector<int>&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        ++written;
      },
      true);
  for (int i = 0; i < 5; ++i) {
    batches.add(i);
    batches.hand_over();
    EXPECT_GE(written, i) << "all but the one that was just handed over";
  }
}

TEST(Batches, WhatTheWriterThrowsIsToldOnce) {
  for (const bool threaded : {false, true}) {
    Batches<int> batches([](const std::vector<int>&) { throw std::runtime_error("the disk is full"); }, threaded);
    batches.add(1);
    batches.hand_over();
    EXPECT_THROW(batches.join(), std::runtime_error) << threaded;
    EXPECT_NO_THROW(batches.hand_over()) << threaded;
  }
}

}  // namespace
}  // namespace amiss::recording
