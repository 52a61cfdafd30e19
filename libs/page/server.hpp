// A small web server for one run: the page and the pictures over HTTP, what happens over a WebSocket.
// Options, files, history -> an address to open. It has a thread of its own, of low priority; the run only ever appends
// to the history and asks the pace. Slow clients stay behind, dead and rude ones are dropped: at most kMostConnections
// connections (the oldest one that is not a socket makes room), kMostSockets sockets, 8 KiB of header, 256 bytes of
// message, 50 messages a second, 10 s for a request.
// ArgumentError where the address is none, the port is taken and must be this one, or others can reach the address and
// there is no token.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "page/history.hpp"
#include "page/pace.hpp"

namespace amiss::page {

struct ServerOptions {
  std::string address = "127.0.0.1";
  int port = 0;  // 0: any that is free
  std::string token;
  bool or_another_port = false;  // one that is free, where `port` is taken
};

/// A file of the run folder that pages may read, whole or by Range; it may grow.
struct ServedFile {
  std::string route, content_type;
  std::filesystem::path file;
};

class Server {
 public:
  static constexpr std::size_t kMostConnections = 64, kMostSockets = 16;

  /// `pace`: of a run that is going on, else nullptr. All references outlive the server.
  Server(const ServerOptions& options, std::vector<ServedFile> files, History& history, Pace* pace);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// What to open in a browser, with the token if there is one; on other machines too if they reach the address.
  [[nodiscard]] std::string url() const;
  [[nodiscard]] int port() const;
  [[nodiscard]] std::size_t watchers() const;     // pages that are connected
  [[nodiscard]] std::size_t connections() const;  // all, for tests and the curious

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace amiss::page
