// What all connections of one server share. Only the server's thread touches it, but for the counters and the wake-up.
#pragma once

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "page/bundle.hpp"
#include "page/guard.hpp"
#include "page/history.hpp"
#include "page/pace.hpp"
#include "page/server.hpp"

namespace amiss::page {

class SocketSession;

struct Site {
  static constexpr std::chrono::milliseconds kRest{40};

  Site(History& told, Pace* set) : history(told), pace(set) {}

  Policy policy;
  std::map<std::string, Asset, std::less<>> assets;
  std::map<std::string, ServedFile, std::less<>> files;
  History& history;
  Pace* pace;  // nullptr: nothing to be paused
  std::atomic<std::size_t> connections = 0, sockets = 0;
  std::list<std::weak_ptr<SocketSession>> watching;
  std::atomic<bool> woken = false;
  boost::asio::io_context context{1};  // after these: what its handlers hold looks at them when it goes
  boost::asio::steady_timer rest{context};

  /// From any thread: there is something new to send. What comes within a rest goes out together: a run that is many
  /// times faster than real would else be interrupted for each of its events.
  void wake() {
    if (woken.exchange(true)) return;
    boost::asio::post(context, [this] {
      rest.async_wait([this](boost::system::error_code) {
        woken = false;
        rest.expires_after(kRest);
        send_news();
      });
    });
  }
  void send_news();  // in socket_session.cpp
};

}  // namespace amiss::page
