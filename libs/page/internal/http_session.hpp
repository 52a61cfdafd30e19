// One connection: requests one after the other, each judged by the guard, until it becomes a WebSocket, closes or takes
// too long.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <optional>

#include "page/internal/site.hpp"

namespace amiss::page {

class HttpSession : public std::enable_shared_from_this<HttpSession> {
 public:
  HttpSession(boost::asio::ip::tcp::socket socket, Site& site);
  ~HttpSession();
  HttpSession(const HttpSession&) = delete;
  HttpSession& operator=(const HttpSession&) = delete;

  void read();
  void drop();

 private:
  using Parser = boost::beast::http::request_parser<boost::beast::http::empty_body>;

  void answer();
  void send_refusal(const Verdict& verdict);
  void send_asset(const Asset& asset);
  void send_file(const ServedFile& file);
  void send_slice(const ServedFile& file, std::size_t begin, std::size_t end);
  template <class Body>
  void send(boost::beast::http::response<Body> response);

  boost::beast::tcp_stream stream_;
  Site& site_;
  boost::beast::flat_buffer buffer_;
  std::optional<Parser> parser_;
};

}  // namespace amiss::page
