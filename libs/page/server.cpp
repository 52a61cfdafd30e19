#include "page/server.hpp"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/ip/v6_only.hpp>
#include <thread>

#include "core/result.hpp"
#include "page/address.hpp"
#include "page/internal/http_session.hpp"
#include "page/internal/ip_address.hpp"

namespace amiss::page {

namespace asio = boost::asio;
using asio::ip::tcp;

namespace {

constexpr int kNiceness = 10;  // the run goes first
constexpr std::chrono::milliseconds kAfterFailure(100);

void check_token(const ServerOptions& options) {
  if (options.token.empty()) {
    if (is_loopback(options.address)) return;
    throw ArgumentError("--address " + options.address +
                        ": other machines can reach it; give a --token as well (or AMISS_TOKEN)");
  }
  const bool plain = std::all_of(options.token.begin(), options.token.end(),
                                 [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; });
  if (!plain || options.token.size() < 8 || options.token.size() > 128) {
    throw ArgumentError("--token: 8 to 128 letters, digits, - and _ are allowed");
  }
}

}  // namespace

struct Server::Impl {
  Impl(const ServerOptions& asked, std::vector<ServedFile> files, History& history, Pace* pace)
      : options(asked), site(history, pace), acceptor(site.context), retry(site.context) {
    check_token(options);
    listen();
    describe(std::move(files));
    accept();
    history.set_listener([this] { site.wake(); });
    thread = std::thread([this] { serve(); });
  }
  ~Impl() {
    site.history.set_listener({});
    site.context.stop();
    thread.join();
  }

  void listen() {
    const asio::ip::address address = ip_address(options.address);
    try {
      boost::system::error_code taken = listen_at({address, static_cast<std::uint16_t>(options.port)});
      if (taken == asio::error::address_in_use && options.or_another_port) taken = listen_at({address, 0});
      if (taken) throw boost::system::system_error(taken);
    } catch (const boost::system::system_error& e) {
      throw ArgumentError("--port " + std::to_string(options.port) + " of " + options.address + ": " +
                          e.code().message() + "; 0 takes any that is free");
    }
    port = acceptor.local_endpoint().port();
  }

  /// Of all that can go wrong, a port that is taken is told by its code.
  boost::system::error_code listen_at(const tcp::endpoint& endpoint) {
    boost::system::error_code error;
    acceptor = tcp::acceptor(site.context);
    acceptor.open(endpoint.protocol());
    acceptor.set_option(asio::socket_base::reuse_address(true));
    if (endpoint.address().is_unspecified() && endpoint.address().is_v6())
      acceptor.set_option(asio::ip::v6_only(false));
    acceptor.bind(endpoint, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    return error;
  }

  void describe(std::vector<ServedFile> files) {
    site.policy.hosts = own_hosts(options.address, port);
    if (!is_loopback(options.address)) site.policy.port_of_literals = port;
    site.policy.token = options.token;
    site.policy.socket_route = "/events";
    for (const Asset& asset : bundle()) site.assets.emplace(asset.route, asset);
    for (ServedFile& file : files) site.files.emplace(file.route, std::move(file));
    for (const auto& [route, asset] : site.assets) site.policy.routes.insert(route);
    for (const auto& [route, file] : site.files) site.policy.routes.insert(route);
  }

  void serve() {
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid)), kNiceness);
    while (!site.context.stopped()) {
      try {
        site.context.run();
      } catch (const std::exception&) {
        // Of one connection (out of memory, out of files): it is gone with its handler, the others go on.
      }
    }
  }

  void accept() {
    acceptor.async_accept([this](boost::system::error_code error, tcp::socket socket) {
      if (error) {
        retry.expires_after(kAfterFailure);
        return retry.async_wait([this](boost::system::error_code) { accept(); });
      }
      make_room();
      const auto session = std::make_shared<HttpSession>(std::move(socket), site);
      sessions.push_back(session);
      session->read();
      accept();
    });
  }

  void make_room() {
    std::erase_if(sessions, [](const auto& session) { return session.expired(); });
    while (sessions.size() + site.sockets >= kMostConnections && !sessions.empty()) {
      if (const auto oldest = sessions.front().lock()) oldest->drop();
      sessions.pop_front();
    }
  }

  const ServerOptions options;
  Site site;
  tcp::acceptor acceptor;
  asio::steady_timer retry;
  std::list<std::weak_ptr<HttpSession>> sessions;
  int port = 0;
  std::thread thread;
};

Server::Server(const ServerOptions& options, std::vector<ServedFile> files, History& history, Pace* pace)
    : impl_(std::make_unique<Impl>(options, std::move(files), history, pace)) {}
Server::~Server() = default;

int Server::port() const { return impl_->port; }
std::size_t Server::watchers() const { return impl_->site.sockets; }
std::size_t Server::connections() const { return impl_->site.connections; }

std::string Server::url() const {
  const std::string query = impl_->options.token.empty() ? "" : "?token=" + impl_->options.token;
  return "http://" + address_to_open(impl_->options.address) + ":" + std::to_string(impl_->port) + "/" + query;
}

}  // namespace amiss::page
