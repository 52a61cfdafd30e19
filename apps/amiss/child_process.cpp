#include "child_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <list>
#include <stdexcept>
#include <thread>

#include "core/files.hpp"
#include "interrupt.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostOutput = std::size_t{64} << 20U;

/// A folder that is gone at the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "amiss-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": cannot be made");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

struct Child {
  std::size_t index = 0;
  pid_t pid = 0;
  Clock::time_point began;
  bool too_slow = false;
  fs::path out, err;
};

pid_t start(const std::vector<std::string>& arguments, const fs::path& out, const fs::path& err) {
  std::vector<std::string> words{"/proc/self/exe"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const std::string program = fs::read_symlink("/proc/self/exe").string();
  const pid_t pid = ::fork();
  if (pid < 0) throw std::runtime_error("a child process cannot be started");
  if (pid > 0) return pid;
  const int to_out = ::open(out.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  const int to_err = ::open(err.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  if (::dup2(to_out, STDOUT_FILENO) >= 0 && ::dup2(to_err, STDERR_FILENO) >= 0) ::execv(program.c_str(), argv.data());
  ::_exit(127);
}

ChildResult result_of(const Child& child, int wait_status) {
  ChildResult result;
  if (WIFSIGNALED(wait_status)) result.signal = WTERMSIG(wait_status);
  if (WIFEXITED(wait_status)) result.status = WEXITSTATUS(wait_status);
  result.too_slow = child.too_slow;
  result.out = load_bytes(child.out, kMostOutput);
  result.err = load_bytes(child.err, kMostOutput);
  result.wall_s = std::chrono::duration<double>(Clock::now() - child.began).count();
  return result;
}

}  // namespace

void run_children(const std::vector<std::vector<std::string>>& arguments, int parallel, std::chrono::seconds limit,
                  const std::function<void(std::size_t, ChildResult)>& ended) {
  using namespace std::chrono_literals;
  const ScratchFolder scratch;
  std::list<Child> running;
  std::size_t next = 0;
  while (!running.empty() || (next < arguments.size() && !interrupted())) {
    while (std::ssize(running) < parallel && next < arguments.size() && !interrupted()) {
      const fs::path out = scratch.path() / (std::to_string(next) + ".out"),
                     err = fs::path(out).replace_extension("err");
      running.push_back({next, start(arguments[next], out, err), Clock::now(), false, out, err});
      ++next;
    }
    bool any = false;
    for (auto child = running.begin(); child != running.end();) {
      int status = 0;
      if (::waitpid(child->pid, &status, WNOHANG) != child->pid) {
        child->too_slow = child->too_slow || Clock::now() - child->began > limit;
        if (child->too_slow || interrupted()) ::kill(child->pid, SIGKILL);
        ++child;
        continue;
      }
      ended(child->index, result_of(*child, status));
      child = running.erase(child);
      any = true;
    }
    if (!any && !running.empty()) std::this_thread::sleep_for(5ms);
  }
}

}  // namespace amiss::app
