#include "view_options.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdlib>
#include <iostream>

namespace amiss::app {

namespace {

bool has_desktop() {
  const auto set = [](const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
  };
  return ::isatty(STDERR_FILENO) != 0 && (set("DISPLAY") || set("WAYLAND_DISPLAY"));
}

void open_browser(std::string url) {
  std::string program = "xdg-open";
  const std::array<char*, 3> arguments{program.data(), url.data(), nullptr};
  pid_t child = 0;
  if (::posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments.data(), environ) == 0) {
    ::waitpid(child, nullptr, 0);  // it hands over to the browser and ends
  }
}

}  // namespace

void add_view_options(CLI::App& command, ViewOptions& options, bool live) {
  if (live) {
    command.add_flag("--view", options.wanted, "show the run in a browser while it goes on");
    command.add_option("--speed", options.speed, "with --view: times real time at most; 0 is as fast as possible")
        ->check(CLI::Range(0.0, 1000.0));
  }
  command.add_option("--address", options.server.address, "of the page; one that others can reach asks for a token")
      ->capture_default_str();
  command.add_option("--port", options.server.port, "of the page; 0 takes any that is free")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  command.add_option("--token", options.server.token, "that a browser has to know: 8 to 128 letters and digits");
}

void announce(const page::Server& server) {
  std::cerr << "amiss: watch at " << server.url() << std::endl;
  if (has_desktop()) open_browser(server.url());
}

}  // namespace amiss::app
