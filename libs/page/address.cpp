#include "page/address.hpp"

#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cstring>

#include "page/internal/ip_address.hpp"

namespace amiss::page {

namespace ip = boost::asio::ip;

namespace {

constexpr int kHttpPort = 80;  // which browsers leave out

ip::address address_of(const ifaddrs& interface) {
  if (interface.ifa_addr->sa_family == AF_INET) {
    sockaddr_in socket{};
    std::memcpy(&socket, interface.ifa_addr, sizeof socket);
    return ip::address_v4(ntohl(socket.sin_addr.s_addr));
  }
  sockaddr_in6 socket{};
  std::memcpy(&socket, interface.ifa_addr, sizeof socket);
  ip::address_v6::bytes_type bytes{};
  std::memcpy(bytes.data(), &socket.sin6_addr, bytes.size());
  return ip::address_v6(bytes);
}

/// Of the interfaces that are up. Link-local ones mean nothing without their interface, and are left out.
std::vector<ip::address> reachable_addresses() {
  std::vector<ip::address> addresses;
  ifaddrs* first = nullptr;
  if (::getifaddrs(&first) != 0) return addresses;
  for (const ifaddrs* i = first; i != nullptr; i = i->ifa_next) {
    const bool is_ip =
        i->ifa_addr != nullptr && (i->ifa_addr->sa_family == AF_INET || i->ifa_addr->sa_family == AF_INET6);
    if (!is_ip || (i->ifa_flags & IFF_UP) == 0U) continue;
    const ip::address address = address_of(*i);
    if (!address.is_loopback() && !(address.is_v6() && address.to_v6().is_link_local())) addresses.push_back(address);
  }
  ::freeifaddrs(first);
  return addresses;
}

std::string in_url(const ip::address& address) {
  return address.is_v6() ? "[" + address.to_string() + "]" : address.to_string();
}

std::string host_name() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return {};
  std::string small(name.data());
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return small;
}

}  // namespace

bool is_loopback(const std::string& address) { return ip_address(address).is_loopback(); }

std::string address_to_open(const std::string& text) {
  const ip::address address = ip_address(text);
  if (!address.is_unspecified()) return in_url(address);
  std::string other;  // an address of version 6, which :: is asked at too
  for (const ip::address& own : reachable_addresses()) {
    if (own.is_v4()) return in_url(own);
    if (address.is_v6() && other.empty()) other = in_url(own);
  }
  return other.empty() ? "127.0.0.1" : other;
}

std::vector<std::string> own_hosts(const std::string& text, int port) {
  std::vector<std::string> names{in_url(ip_address(text)), "localhost"};
  if (is_loopback(text)) {
    names.insert(names.end(), {"127.0.0.1", "[::1]"});
  } else if (const std::string name = host_name(); !name.empty()) {
    names.push_back(name);
  }
  std::vector<std::string> hosts;
  for (const std::string& name : names) {
    hosts.push_back(name + ":" + std::to_string(port));
    if (port == kHttpPort) hosts.push_back(name);
  }
  return hosts;
}

}  // namespace amiss::page
