// Where a page is served: an IP address as a user gives it -> whether others reach it, what is to be opened in a
// browser, which values of Host are this machine.
#pragma once

#include <string>
#include <vector>

namespace amiss::page {

/// Can only this machine reach it? ArgumentError for what is no IP address; localhost is 127.0.0.1.
[[nodiscard]] bool is_loopback(const std::string& address);

/// For an URL, in brackets where it needs them. Of all addresses of this machine (0.0.0.0, ::) the first one that
/// others can reach, else 127.0.0.1.
[[nodiscard]] std::string address_to_open(const std::string& address);

/// Values of Host with this port: the address, and for the loopback its names, for others the machine's.
[[nodiscard]] std::vector<std::string> own_hosts(const std::string& address, int port);

}  // namespace amiss::page
