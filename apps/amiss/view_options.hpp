// Options of everything that serves a page, and how its address is told.
#pragma once

#include <string>

#include "page/server.hpp"

namespace CLI {
class App;
}

namespace amiss::app {

struct ViewOptions {
  bool wanted = false;
  page::ServerOptions server{"127.0.0.1", 7474, "", true};  // another port where that one is taken
  double speed = 0.0;                                       // times real time, 0: as fast as possible
};

/// --address, --port and --token; for live runs also --view and --speed.
void add_view_options(CLI::App& command, ViewOptions& options, bool live);

/// The address on standard error, and in a browser where there is a desktop.
void announce(const page::Server& server, const ViewOptions& options);

}  // namespace amiss::app
