#include "core/worker.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <vector>

namespace amiss {
namespace {

class WorkerOf : public testing::TestWithParam<bool> {};

TEST_P(WorkerOf, KeepsTheOrder) {
  std::vector<int> done;
  {
    Worker worker(GetParam());
    for (int i = 0; i < 500; ++i) worker.submit([&done, i] { done.push_back(i); });
  }  // what was submitted is done before the worker is gone
  ASSERT_EQ(done.size(), 500U);
  for (int i = 0; i < 500; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
}

TEST_P(WorkerOf, ReturnsValues) {
  Worker worker(GetParam());
  std::vector<std::future<int>> squares;
  for (int i = 0; i < 20; ++i) squares.push_back(worker.submit([i] { return i * i; }));
  for (int i = 0; i < 20; ++i) EXPECT_EQ(squares[static_cast<std::size_t>(i)].get(), i * i);
}

TEST_P(WorkerOf, HandsExceptionsToWhoAsks) {
  Worker worker(GetParam());
  auto broken = worker.submit([]() -> int { throw std::runtime_error("broken"); });
  auto sound = worker.submit([] { return 7; });
  EXPECT_THROW(broken.get(), std::runtime_error);
  EXPECT_EQ(sound.get(), 7) << "the worker goes on";
}

INSTANTIATE_TEST_SUITE_P(Threads, WorkerOf, testing::Bool(),
                         [](const auto& tested) { return tested.param ? "Two" : "One"; });

TEST(Worker, WithoutAThreadTheCallerWorks) {
  Worker worker(false);
  std::thread::id where;
  auto done = worker.submit([&where] { where = std::this_thread::get_id(); });
  EXPECT_EQ(done.wait_for(std::chrono::seconds(0)), std::future_status::ready) << "done when submit returns";
  EXPECT_EQ(where, std::this_thread::get_id());
}

TEST(Worker, WithAThreadAnotherWorks) {
  Worker worker(true);
  auto where = worker.submit([] { return std::this_thread::get_id(); });
  EXPECT_NE(where.get(), std::this_thread::get_id());
}

TEST(Worker, ItsThreadMayLetOthersGoFirst) {
  const auto niceness = [] { return ::getpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid))); };
  const int own = niceness();
  Worker polite(true, 3), usual(true), none(false, 3);
  EXPECT_EQ(polite.submit(niceness).get(), std::min(own + 3, 19));
  EXPECT_EQ(usual.submit(niceness).get(), own);
  EXPECT_EQ(none.submit(niceness).get(), own) << "the caller's thread stays as it was";
}

}  // namespace
}  // namespace amiss
