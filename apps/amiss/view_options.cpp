#include "view_options.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iostream>
#include <thread>
#include <vector>

namespace amiss::app {

namespace {

bool has_desktop() {
  const auto set = [](const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
  };
  return ::isatty(STDERR_FILENO) != 0 && (set("DISPLAY") || set("WAYLAND_DISPLAY"));
}

/// What a child begins with: nothing of this program's input, output and sockets, so that it can outlive it.
class DetachedSpawn {
 public:
  DetachedSpawn() {
    ::posix_spawn_file_actions_init(&files_);
    ::posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&files_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addopen(&files_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addclosefrom_np(&files_, STDERR_FILENO + 1);
    ::posix_spawnattr_init(&attributes_);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSID);
  }
  ~DetachedSpawn() {
    ::posix_spawnattr_destroy(&attributes_);
    ::posix_spawn_file_actions_destroy(&files_);
  }
  DetachedSpawn(const DetachedSpawn&) = delete;
  DetachedSpawn& operator=(const DetachedSpawn&) = delete;

  void start(std::vector<std::string> words) const {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t child = 0;
    if (::posix_spawnp(&child, arguments[0], &files_, &attributes_, arguments.data(), environ) != 0) return;
    std::thread([child] { ::waitpid(child, nullptr, 0); }).detach();  // no zombie stays, nobody waits
  }

 private:
  posix_spawn_file_actions_t files_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

void add_view_options(CLI::App& command, ViewOptions& options, bool live) {
  if (live) {
    command.add_flag("--view", options.wanted, "show the run in a browser while it goes on");
    command.add_option("--speed", options.speed, "with --view: times real time at most; 0 is as fast as possible")
        ->check(CLI::Range(0.0, 1000.0));
  }
  command.add_option("--address", options.server.address, "of the page; one that others can reach asks for a token")
      ->capture_default_str();
  command
      .add_option("--port", options.server.port, "of the page; 0 takes any that is free [7474, or one that is free]")
      ->check(CLI::Range(0, 65535))
      ->each([&options](const std::string&) { options.server.or_another_port = false; });
  command.add_option("--token", options.server.token, "that a browser has to know: 8 to 128 letters and digits")
      ->envname("AMISS_TOKEN");
}

void announce(const page::Server& server, const ViewOptions& options) {
  const int asked = options.server.port;
  if (asked != 0 && server.port() != asked) {
    std::cerr << "amiss: port " << asked << " is taken, so the page is at " << server.port() << "\n";
  }
  std::cerr << "amiss: watch at " << server.url() << std::endl;
  if (has_desktop()) DetachedSpawn().start({"xdg-open", server.url()});
}

}  // namespace amiss::app
