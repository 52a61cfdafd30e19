#include "page/address.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "core/result.hpp"

namespace amiss::page {
namespace {

bool holds(const std::vector<std::string>& hosts, const std::string& host) {
  return std::find(hosts.begin(), hosts.end(), host) != hosts.end();
}

TEST(Address, LoopbackIsForThisMachineAlone) {
  for (const char* address : {"127.0.0.1", "127.9.9.9", "::1", "localhost"})
    EXPECT_TRUE(is_loopback(address)) << address;
  for (const char* address : {"0.0.0.0", "::", "192.0.2.7", "2001:db8::7"})
    EXPECT_FALSE(is_loopback(address)) << address;
  for (const char* address : {"", "kitchen", "127.0.0", "127.0.0.1:80", "[::1]"}) {
    EXPECT_THROW((void)is_loopback(address), ArgumentError) << address;
  }
}

TEST(Address, IsOpenedAsItIsGiven) {
  EXPECT_EQ(address_to_open("127.0.0.1"), "127.0.0.1");
  EXPECT_EQ(address_to_open("localhost"), "127.0.0.1");
  EXPECT_EQ(address_to_open("192.0.2.7"), "192.0.2.7");
  EXPECT_EQ(address_to_open("2001:db8::7"), "[2001:db8::7]");
}

/// No browser opens "all addresses".
TEST(Address, OfAllAddressesOneIsToBeOpened) {
  for (const char* all : {"0.0.0.0", "::"}) {
    const std::string address = address_to_open(all);
    EXPECT_NE(address, "0.0.0.0");
    EXPECT_NE(address, "[::]");
    EXPECT_EQ(address.find("fe80"), std::string::npos);
    EXPECT_FALSE(address.empty());
  }
}

TEST(Address, TheLoopbackHasItsNames) {
  const auto hosts = own_hosts("127.0.0.1", 7474);
  for (const char* host : {"127.0.0.1:7474", "localhost:7474", "[::1]:7474"}) EXPECT_TRUE(holds(hosts, host)) << host;
  EXPECT_FALSE(holds(hosts, "127.0.0.1"));
  EXPECT_TRUE(holds(own_hosts("127.9.9.9", 7474), "127.9.9.9:7474"));
  EXPECT_TRUE(holds(own_hosts("127.0.0.1", 80), "localhost")) << "browsers leave out the port of HTTP";
}

TEST(Address, OthersHaveTheNameOfTheMachine) {
  std::array<char, 256> name{};
  ASSERT_EQ(::gethostname(name.data(), name.size() - 1), 0);
  std::string machine(name.data());
  std::transform(machine.begin(), machine.end(), machine.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto hosts = own_hosts("192.0.2.7", 7474);
  EXPECT_TRUE(holds(hosts, "192.0.2.7:7474"));
  EXPECT_TRUE(holds(hosts, machine + ":7474"));
  EXPECT_FALSE(holds(own_hosts("127.0.0.1", 7474), machine + ":7474"));
}

}  // namespace
}  // namespace amiss::page
