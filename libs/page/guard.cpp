#include "page/guard.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace amiss::page {

namespace {

constexpr std::string_view kTokenQuery = "/?token=";

bool cookie_holds(std::string_view cookies, std::string_view token) {
  while (!cookies.empty()) {
    const std::size_t end = std::min(cookies.find(';'), cookies.size());
    std::string_view one = cookies.substr(0, end);
    cookies.remove_prefix(std::min(end + 1, cookies.size()));
    while (one.starts_with(' ')) one.remove_prefix(1);
    if (!one.starts_with(kCookie) || one.substr(kCookie.size(), 1) != "=") continue;
    if (same_secret(one.substr(kCookie.size() + 1), token)) return true;
  }
  return false;
}

/// A page of another site may link here, but not reach in.
bool from_elsewhere(const Request& request) {
  if (!request.origin.empty() && request.origin != "http://" + std::string(request.host)) return true;
  const bool other_site = request.fetch_site == "cross-site" || request.fetch_site == "same-site";
  return other_site && (request.upgrade || (request.target != "/" && !request.target.starts_with(kTokenQuery)));
}

/// "192.0.2.7:7474", "[2001:db8::7]:7474"; browsers leave out the port 80.
bool is_literal_at(const std::string& host, int port) {
  const std::string suffix = ":" + std::to_string(port);
  std::string address = host;
  if (host.ends_with(suffix)) {
    address.resize(host.size() - suffix.size());
  } else if (port != 80) {
    return false;
  }
  if (address.find('\0') != std::string::npos) return false;
  std::array<unsigned char, sizeof(in6_addr)> bytes{};
  if (!address.starts_with('[')) return ::inet_pton(AF_INET, address.c_str(), bytes.data()) == 1;
  if (!address.ends_with(']')) return false;
  return ::inet_pton(AF_INET6, address.substr(1, address.size() - 2).c_str(), bytes.data()) == 1;
}

bool is_own_host(std::string host, const Policy& policy) {
  for (char& c : host) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (std::find(policy.hosts.begin(), policy.hosts.end(), host) != policy.hosts.end()) return true;
  return policy.port_of_literals != 0 && is_literal_at(host, policy.port_of_literals);
}

}  // namespace

bool same_secret(std::string_view a, std::string_view b) {
  unsigned differs = a.size() == b.size() ? 0U : 1U;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const char other = i < b.size() ? b[i] : '\0';
    differs |= static_cast<unsigned>(static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(other));
  }
  return differs == 0U;
}

Verdict judge(const Request& request, const Policy& policy) {
  if (request.host.empty()) return {400, "", "a Host is needed"};
  if (!is_own_host(std::string(request.host), policy)) return {421, "", "this server has another name"};
  if (request.method != "GET" && request.method != "HEAD") return {405, "", "GET and HEAD are allowed"};
  if (from_elsewhere(request)) return {403, "", "asked from another site"};
  if (!policy.token.empty()) {
    if (request.target.starts_with(kTokenQuery)) {
      if (same_secret(request.target.substr(kTokenQuery.size()), policy.token)) return {303, "/", ""};
      return {401, "", "wrong token"};
    }
    if (!cookie_holds(request.cookie, policy.token)) return {401, "", "a token is needed: /?token=..."};
  }
  if (request.target == policy.socket_route) {
    if (!request.upgrade || request.method != "GET") return {426, "", "this is a WebSocket"};
    return {101, std::string(request.target), ""};
  }
  const auto route = policy.routes.find(request.target);
  if (route == policy.routes.end() || request.upgrade) return {404, "", "there is nothing here"};
  return {200, *route, ""};
}

}  // namespace amiss::page
