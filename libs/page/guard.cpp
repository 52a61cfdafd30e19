#include "page/guard.hpp"

#include <algorithm>

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
  const auto& hosts = policy.hosts;
  if (request.host.empty()) return {400, "", "a Host is needed"};
  if (!hosts.empty() && std::find(hosts.begin(), hosts.end(), request.host) == hosts.end()) {
    return {421, "", "this server has another name"};
  }
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
