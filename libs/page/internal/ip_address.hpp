// An IP address as a user gives it, in Boost's words.
#pragma once

#include <boost/asio/ip/address.hpp>
#include <string>

#include "core/result.hpp"

namespace amiss::page {

/// ArgumentError for what is none; localhost is 127.0.0.1.
inline boost::asio::ip::address ip_address(const std::string& text) {
  boost::system::error_code error;
  const auto address = boost::asio::ip::make_address(text == "localhost" ? "127.0.0.1" : text, error);
  if (error) throw ArgumentError("--address " + text + ": an IP address such as 127.0.0.1 is allowed");
  return address;
}

}  // namespace amiss::page
