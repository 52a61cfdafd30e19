#include "core/files.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"

namespace amiss {
namespace {

namespace fs = std::filesystem;
using test::sentence_of;
using test::TemporaryFolder;

TEST(Files, KnownDigests) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_NE(sha256(std::string_view("a\0b", 3)), sha256("a"));
}

RC_GTEST_PROP(Files, WhatIsSavedIsLoaded, (const std::string& bytes)) {
  const TemporaryFolder folder;
  save_atomically(folder.path() / "file", bytes);
  RC_ASSERT(load_bytes(folder.path() / "file") == bytes);
  RC_ASSERT(folder.count() == 1U);
}

TEST(Files, LargeFilesAreWholeAndReplaced) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "file";
  save_atomically(file, std::string(5'000'000, 'a'));
  EXPECT_EQ(load_bytes(file), std::string(5'000'000, 'a'));
  save_atomically(file, "b");
  EXPECT_EQ(load_bytes(file), "b");
}

TEST(Files, WhatCannotBeReadIsRefusedByName) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("file", "12345");
  EXPECT_EQ(load_bytes(file, 5), "12345");
  EXPECT_EQ(sentence_of<InputError>([&] { (void)load_bytes(file, 4); }),
            file.string() + ": is larger than the 4 bytes allowed here");
  EXPECT_EQ(sentence_of<InputError>([&] { (void)load_bytes(folder.path() / "none"); }),
            (folder.path() / "none").string() + ": there is no such file");
  EXPECT_NE(sentence_of<InputError>([&] { (void)load_bytes(folder.path()); }).find("is a folder"), std::string::npos);
  EXPECT_THROW((void)load_bytes("/dev/zero", 1U << 20U), InputError) << "endless, but the limit holds";
}

TEST(Files, FolderThatIsNotThere) {
  const TemporaryFolder folder;
  EXPECT_THROW(save_atomically(folder.path() / "none" / "file", "x"), std::runtime_error);
  EXPECT_EQ(folder.count(), 0U);
}

TEST(Files, FolderInThePlaceOfTheFileStays) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "file" / "inner");
  EXPECT_THROW(save_atomically(folder.path() / "file", "x"), std::runtime_error);
  EXPECT_TRUE(fs::is_directory(folder.path() / "file" / "inner"));
  EXPECT_EQ(folder.count(), 1U) << "no temporary file is left";
}

TEST(Files, NothingCanBeMadeInProc) {  // whoever asks
  EXPECT_THROW(save_atomically("/proc/amiss_test", "x"), std::runtime_error);
}

/// Runs `act` in a child; its exit status, or -1 when a signal ended it.
template <class Act>
int status_of_child(const Act& act) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(act());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Files, ReadOnlyFolder) {
  const TemporaryFolder folder;
  folder.write("file", "old");
  fs::permissions(folder.path(), fs::perms(0555));
  const int status = status_of_child([&] {
    constexpr uid_t kNobody = 65534;  // root may write everywhere
    if (::geteuid() == 0 && ::seteuid(kNobody) != 0) return 3;
    try {
      save_atomically(folder.path() / "file", "new");
    } catch (const std::runtime_error&) {
      return 1;
    }
    return 0;
  });
  fs::permissions(folder.path(), fs::perms(0755));
  EXPECT_EQ(status, 1);
  EXPECT_EQ(folder.read("file"), "old");
}

TEST(Files, NoSpaceLeavesTheOldFile) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("file", "old");
  const int status = status_of_child([&] {
    ::signal(SIGXFSZ, SIG_IGN);  // writing beyond the limit then fails, as on a full disk
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      save_atomically(file, std::string(100'000, 'n'));
    } catch (const std::runtime_error& e) {
      return std::string_view(e.what()).find("cannot be written") == std::string_view::npos ? 2 : 1;
    }
    return 0;
  });
  EXPECT_EQ(status, 1);
  EXPECT_EQ(folder.read("file"), "old");
  EXPECT_EQ(folder.count(), 1U) << "no temporary file is left";
}

TEST(Files, KilledWriterLeavesAWholeFile) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "file";
  const std::string a(300'000, 'a'), b(200'000, 'b');
  save_atomically(file, a);
  for (int round = 0; round < 20; ++round) {
    const pid_t child = ::fork();
    if (child == 0) {
      while (true) {
        save_atomically(file, b);
        save_atomically(file, a);
      }
    }
    std::this_thread::sleep_for(std::chrono::microseconds(500 + 731 * round));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::string left = load_bytes(file);
    EXPECT_TRUE(left == a || left == b) << left.size() << " bytes";
  }
}

}  // namespace
}  // namespace amiss
