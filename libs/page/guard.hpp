// Who may ask for what: the one place that decides, a function of a request's headers alone.
// Request -> status and reason. Routes match exactly, so no path can lead out of them. A browser that was lured here
// by another site is recognised by Host (DNS rebinding), Origin and Sec-Fetch-Site. An IP literal as Host is nobody's
// name, so a page that was got under one came from that address.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace amiss::page {

struct Request {
  std::string_view method, target, host, origin, fetch_site, cookie;
  bool upgrade = false;  // to a WebSocket
};

struct Policy {
  std::vector<std::string> hosts;  // values of Host that are this server, in small letters
  int port_of_literals = 0;        // any IP literal with this port is this server too; 0: none is
  std::string token;               // empty: none is asked for
  std::set<std::string, std::less<>> routes;
  std::string socket_route;  // the one that is a WebSocket
};

/// 200: answer with what `route` stands for; 101: open the socket; 303: the token was right, set the cookie and go to
/// "/"; all others are refusals.
struct Verdict {
  int status = 400;
  std::string route, why;
};

[[nodiscard]] Verdict judge(const Request& request, const Policy& policy);

/// Name of the cookie that holds the token.
inline constexpr std::string_view kCookie = "amiss_token";

/// Compares in a time that does not depend on where they differ.
[[nodiscard]] bool same_secret(std::string_view a, std::string_view b);

}  // namespace amiss::page
