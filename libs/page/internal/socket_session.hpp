// A page that watches: it is sent the history from its beginning, then what is new, and may set the pace.
// Messages to it: lines of JSON, at most 64 KiB together unless one line is longer. Messages from it: {"pause": true or
// false}, {"step": true} or {"speed": times real, 0 for as fast as possible}; anything else ends the connection.
#pragma once

#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "page/internal/site.hpp"

namespace amiss::page {

class SocketSession : public std::enable_shared_from_this<SocketSession> {
 public:
  using Upgrade = boost::beast::http::request<boost::beast::http::empty_body>;

  SocketSession(boost::beast::tcp_stream stream, Site& site);
  ~SocketSession();
  SocketSession(const SocketSession&) = delete;
  SocketSession& operator=(const SocketSession&) = delete;

  void run(Upgrade request);
  void send_news();

 private:
  void read();
  void on_read(boost::beast::error_code error);
  void refuse();
  [[nodiscard]] bool obey(const std::string& message);
  [[nodiscard]] std::string pace_line() const;

  boost::beast::websocket::stream<boost::beast::tcp_stream> socket_;
  Site& site_;
  boost::asio::steady_timer rest_;
  boost::beast::flat_buffer received_;
  std::string sending_;
  std::size_t next_line_ = 0;
  int told_pace_ = -1;
  bool open_ = false, writing_ = false;
};

}  // namespace amiss::page
