#include "experiment/process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace amiss::experiment {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPoll(10);
constexpr std::chrono::seconds kGrace(3);  // from SIGTERM to SIGKILL

/// A file in memory, so that neither side ever waits for the other.
class MemoryFile {
 public:
  MemoryFile() : file_(::memfd_create("amiss", MFD_CLOEXEC)) {
    if (file_ < 0) throw std::system_error(errno, std::generic_category(), "no memory for the output of a program");
  }
  ~MemoryFile() { ::close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] int descriptor() const { return file_; }
  void fill(const std::string& bytes) const {
    if (::pwrite(file_, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
      throw std::runtime_error("the input of a program cannot be kept in memory");
    }
  }
  [[nodiscard]] std::string tail(std::size_t kept) const {
    const off_t size = ::lseek(file_, 0, SEEK_END);
    const off_t from = std::max<off_t>(0, size - static_cast<off_t>(kept));
    std::string bytes(static_cast<std::size_t>(size - from), '\0');
    const ssize_t read = ::pread(file_, bytes.data(), bytes.size(), from);
    bytes.resize(read > 0 ? static_cast<std::size_t>(read) : 0);
    return bytes;
  }

 private:
  int file_;
};

/// In the child, after fork: only calls that are safe there.
[[noreturn]] void become(char* const* argv, pid_t parent, const MemoryFile& in, const MemoryFile& out,
                         const MemoryFile& err) {
  constexpr int kNotStarted = 127;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kNotStarted);
  ::dup2(in.descriptor(), STDIN_FILENO);
  ::dup2(out.descriptor(), STDOUT_FILENO);
  ::dup2(err.descriptor(), STDERR_FILENO);
  ::execvp(argv[0], argv);
  ::_exit(kNotStarted);
}

}  // namespace

Ended run_program(const std::vector<std::string>& arguments, const std::string& input,
                  const std::function<bool()>& stop, std::size_t kept) {
  std::vector<std::string> words = arguments;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const MemoryFile in, out, err;
  in.fill(input);
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "no process for " + arguments.front());
  if (child == 0) become(argv.data(), parent, in, out, err);

  Ended ended;
  int status = 0;
  Clock::time_point stopped_at;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (!ended.stopped && stop()) {
      ended.stopped = true;
      stopped_at = Clock::now();
      ::kill(child, SIGTERM);
    }
    if (ended.stopped && Clock::now() - stopped_at > kGrace) ::kill(child, SIGKILL);
    std::this_thread::sleep_for(kPoll);
  }
  if (WIFSIGNALED(status)) ended.signal = WTERMSIG(status);
  if (WIFEXITED(status)) ended.status = WEXITSTATUS(status);
  ended.out = out.tail(kept);
  ended.err = err.tail(kept);
  return ended;
}

std::string shell_quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const auto begin = text.rfind('\n');
  return begin == std::string::npos ? text : text.substr(begin + 1);
}

}  // namespace amiss::experiment
