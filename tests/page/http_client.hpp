// A client that may be rude: plain bytes over a loopback socket.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace amiss::test {

constexpr int kPatience_ms = 30000;  // with a machine that has much else to do

class Client {
 public:
  explicit Client(int port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    sockaddr generic{};
    static_assert(sizeof generic == sizeof address);
    std::copy_n(reinterpret_cast<const char*>(&address), sizeof address, reinterpret_cast<char*>(&generic));
    open_ = socket_ >= 0 && ::connect(socket_, &generic, sizeof generic) == 0;
  }
  ~Client() { close(); }
  Client(Client&& other) noexcept : socket_(std::exchange(other.socket_, -1)), open_(other.open_) {}
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  Client& operator=(Client&&) = delete;

  [[nodiscard]] bool is_open() const { return open_; }
  void close() {
    if (socket_ >= 0) ::close(std::exchange(socket_, -1));
  }

  /// False when the other side has closed.
  bool send(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
  }

  /// What comes until `enough` says so, the other side closes, or nothing comes for a while.
  template <class Enough>
  std::string receive(const Enough& enough) const {
    std::string all;
    char part[65536];
    pollfd waiting{socket_, POLLIN, 0};
    while (!enough(all) && ::poll(&waiting, 1, kPatience_ms) > 0) {
      const ssize_t got = ::recv(socket_, part, sizeof part, 0);
      if (got <= 0) break;
      all.append(part, static_cast<std::size_t>(got));
    }
    return all;
  }
  /// True when the other side closes within the time.
  [[nodiscard]] bool is_closed() const {
    pollfd waiting{socket_, POLLIN, 0};
    char part[4096];
    while (::poll(&waiting, 1, kPatience_ms) > 0) {
      if (::recv(socket_, part, sizeof part, 0) <= 0) return true;
    }
    return false;
  }

 private:
  int socket_ = -1;
  bool open_ = false;
};

struct Answer {
  int status = 0;
  std::string head, body;
};

/// One request and its whole answer, on a connection of its own.
inline Answer ask(int port, const std::string& request) {
  const Client client(port);
  if (!client.send(request)) return {};
  const auto length_of = [](const std::string& text) -> std::size_t {
    const std::size_t at = text.find("Content-Length: ");
    return at == std::string::npos ? 0 : std::stoul(text.substr(at + 16));
  };
  const std::string all = client.receive([&](const std::string& text) {
    const std::size_t end = text.find("\r\n\r\n");
    return end != std::string::npos && text.size() >= end + 4 + length_of(text);
  });
  const std::size_t end = all.find("\r\n\r\n");
  if (end == std::string::npos || all.size() < 12) return {};
  return {std::stoi(all.substr(9, 3)), all.substr(0, end), all.substr(end + 4)};
}

inline Answer get(int port, const std::string& target, const std::string& more = {}) {
  return ask(port, "GET " + target + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\n" + more + "\r\n");
}

/// A WebSocket that is open, or refused.
class SocketClient {
 public:
  explicit SocketClient(int port, const std::string& more = {}) : client_(port) {
    client_.send("GET /events HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
                 "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                 "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
                 more + "\r\n");
    waiting_ = client_.receive([](const std::string& text) { return text.find("\r\n\r\n") != std::string::npos; });
    if (waiting_.size() > 12) status_ = std::stoi(waiting_.substr(9, 3));
    waiting_.erase(0, waiting_.find("\r\n\r\n") + 4);
  }
  [[nodiscard]] int status() const { return status_; }
  [[nodiscard]] const Client& raw() const { return client_; }

  /// A frame from client to server, masked with zeros.
  bool send(std::string_view text, unsigned char kind = 0x81) const {
    std::string frame{static_cast<char>(kind)};
    frame += static_cast<char>(0x80U | (text.size() < 126 ? text.size() : 126U));
    if (text.size() >= 126) {
      frame += static_cast<char>(text.size() >> 8U);
      frame += static_cast<char>(text.size() & 255U);
    }
    frame.append(4, '\0');
    frame += text;
    return client_.send(frame);
  }

  /// Text of all frames until it holds `last`.
  std::string read_until(std::string_view last) {
    std::string text;
    std::size_t searched = 0;  // text may be long: none of it is searched twice
    while (text.find(last, searched) == std::string::npos) {
      searched = text.size() - std::min(text.size(), last.size());
      if (!take_frame(text)) {
        const std::string more = client_.receive([](const std::string& got) { return !got.empty(); });
        if (more.empty()) break;
        waiting_ += more;
      }
    }
    return text;
  }

 private:
  bool take_frame(std::string& text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(waiting_[i])); };
    if (waiting_.size() < 2) return false;
    std::size_t head = 2, length = byte(1) & 127U;
    const std::size_t wide = length == 126 ? 2 : (length == 127 ? 8 : 0);
    if (waiting_.size() < head + wide) return false;
    if (wide > 0) length = 0;
    for (std::size_t i = 0; i < wide; ++i) length = length << 8U | byte(head + i);
    head += wide;
    if (waiting_.size() < head + length) return false;
    if ((byte(0) & 15U) <= 2) text.append(waiting_, head, length);
    waiting_.erase(0, head + length);
    return true;
  }

  Client client_;
  std::string waiting_;
  int status_ = 0;
};

}  // namespace amiss::test
