// Runs the amiss program as a child: arguments -> exit status and what it wrote.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <vector>

#include "core/temporary_folder.hpp"

namespace amiss::test {

/// Are there pseudo-terminals? A bare chroot has none.
inline bool has_terminals() {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0) return false;
  const bool usable = ::grantpt(terminal) == 0 && ::unlockpt(terminal) == 0;
  ::close(terminal);
  return usable;
}

struct Ended {
  int status = -1;  // -1000 - signal when one ended it
  std::string out, err;
  long peak_kb = 0;  // the most memory that it had at once
};

/// A child that is running; its output goes to files in a folder of its own.
class Program {
 public:
  /// `folder`: where it runs.
  Program(const std::vector<std::string>& arguments, const std::filesystem::path& folder) {
    std::vector<std::string> words{AMISS_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    child_ = ::fork();
    if (child_ != 0) return;
    const bool ready = std::freopen((output_.path() / "out").c_str(), "w", stdout) != nullptr &&
                       std::freopen((output_.path() / "err").c_str(), "w", stderr) != nullptr &&
                       ::chdir(folder.c_str()) == 0;
    if (ready) ::execv(argv[0], argv.data());
    ::_exit(99);
  }
  ~Program() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void send(int signal) const { ::kill(child_, signal); }
  [[nodiscard]] bool runs() const {
    siginfo_t info{};
    ::waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT);
    return info.si_pid == 0;
  }
  [[nodiscard]] std::string said() const { return output_.read("err"); }  // on standard error, so far
  Ended wait() {
    int status = 0;
    rusage used{};
    ::wait4(child_, &status, 0, &used);
    child_ = 0;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1000 - WTERMSIG(status), output_.read("out"),
            output_.read("err"), used.ru_maxrss};
  }

 private:
  TemporaryFolder output_;
  pid_t child_ = 0;
};

/// References are kept in the build folder, so that the mapping run of a world is made once for all tests.
inline void use_test_cache() { ::setenv("XDG_CACHE_HOME", AMISS_TEST_CACHE, 1); }

inline Ended run(const std::vector<std::string>& arguments, const std::filesystem::path& folder) {
  use_test_cache();
  return Program(arguments, folder).wait();
}

}  // namespace amiss::test
