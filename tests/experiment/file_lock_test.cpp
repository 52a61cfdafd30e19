#include "experiment/file_lock.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <thread>

#include "core/temporary_folder.hpp"

namespace amiss::experiment {
namespace {

namespace fs = std::filesystem;

TEST(FileLock, IsHeldByOne) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "lock";
  {
    auto lock = FileLock::take(file);
    ASSERT_TRUE(lock);
    EXPECT_FALSE(FileLock::take(file));
    const FileLock moved = std::move(*lock);
    lock.reset();
    EXPECT_FALSE(FileLock::take(file)) << "what was moved from gives nothing up";
  }
  EXPECT_FALSE(fs::exists(file));
  EXPECT_TRUE(FileLock::take(file));
  EXPECT_THROW((void)FileLock::take(folder.path() / "none" / "lock"), std::runtime_error);
}

TEST(FileLock, IsFreeWhenItsProcessWasKilled) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "lock";
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const auto lock = FileLock::take(file);
    const char word = lock ? 'y' : 'n';
    if (::write(ends[1], &word, 1) == 1) ::pause();
    ::_exit(0);
  }
  char word = 0;
  ASSERT_EQ(::read(ends[0], &word, 1), 1);
  EXPECT_EQ(word, 'y');
  EXPECT_FALSE(FileLock::take(file));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(fs::exists(file));
  EXPECT_TRUE(FileLock::take(file));
  for (const int end : ends) ::close(end);
}

/// The file is removed and made again all the time: never do two hold it.
TEST(FileLock, IsNeverHeldTwice) {
  const test::TemporaryFolder folder;
  std::atomic<int> holders = 0, most = 0, taken = 0;
  const auto work = [&] {
    for (int i = 0; i < 2000; ++i) {
      const auto lock = FileLock::take(folder.path() / "lock");
      if (!lock) continue;
      ++taken;
      const int now = ++holders;
      if (now > most) most = now;
      --holders;
    }
  };
  std::thread first(work), second(work), third(work);
  for (std::thread* thread : {&first, &second, &third}) thread->join();
  EXPECT_EQ(most, 1);
  EXPECT_GT(taken, 100);
}

}  // namespace
}  // namespace amiss::experiment
