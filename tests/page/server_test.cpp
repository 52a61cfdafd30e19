#include "page/server.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "core/random.hpp"
#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "page/bundle.hpp"
#include "page/http_client.hpp"

namespace amiss::page {
namespace {

using namespace std::chrono_literals;
using test::Answer;
using test::Client;
using test::get;
using test::SocketClient;

/// Resident memory of this program, server included [bytes].
std::size_t resident() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages >> pages;
  return pages * 4096;
}
constexpr std::size_t kFlat = std::size_t{24} << 20;

template <class Condition>
bool soon(const Condition& holds) {
  for (int i = 0; i < 500 && !holds(); ++i) std::this_thread::sleep_for(10ms);
  return holds();
}

struct ServerOf : testing::Test {
  test::TemporaryFolder folder;
  History history;
  Pace pace;
  std::vector<ServedFile> files{{"/camera.bin", "application/octet-stream", folder.write("camera.bin", "0123456789")},
                                {"/report.json", "application/json", folder.path() / "not_yet.json"}};
  Server server{{}, files, history, &pace};
  [[nodiscard]] int port() const { return server.port(); }
  [[nodiscard]] bool answers() const { return get(port(), "/app.css").body == bundled("/app.css"); }
};

TEST_F(ServerOf, ShowsThePageAndGuardsIt) {
  for (const Asset& asset : bundle()) {
    const Answer answer = get(port(), std::string(asset.route));
    EXPECT_EQ(answer.status, 200) << asset.route;
    EXPECT_EQ(answer.body, asset.bytes) << asset.route;
    EXPECT_NE(answer.head.find("Content-Security-Policy: default-src 'none'; script-src 'self'"), std::string::npos);
    EXPECT_NE(answer.head.find("X-Content-Type-Options: nosniff"), std::string::npos);
  }
  EXPECT_EQ(server.url(), "http://127.0.0.1:" + std::to_string(port()) + "/");
}

TEST_F(ServerOf, HeadHasNoBody) {
  const Client client(port());
  client.send("HEAD / HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port()) + "\r\nConnection: close\r\n\r\n");
  const std::string answer = client.receive([](const std::string&) { return false; });
  EXPECT_EQ(answer.rfind("HTTP/1.1 200", 0), 0U);
  EXPECT_EQ(answer.substr(answer.size() - 4), "\r\n\r\n");
}

TEST_F(ServerOf, RefusesWhatItShould) {
  EXPECT_EQ(get(port(), "/../../../../etc/passwd").status, 404);
  EXPECT_EQ(get(port(), "/camera.bin/../not_yet.json").status, 404);
  EXPECT_EQ(get(port(), "/%2e%2e/%2e%2e/etc/passwd").status, 404);
  EXPECT_EQ(get(port(), "/report.json").status, 404) << "it is not there yet";
  EXPECT_EQ(get(port(), "/camera.bin", "Sec-Fetch-Site: cross-site\r\n").status, 403);
  EXPECT_EQ(get(port(), "/events").status, 426);
  EXPECT_EQ(test::ask(port(), "GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n").status, 421);
  EXPECT_EQ(test::ask(port(), "POST / HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port()) + "\r\n\r\n").status, 405);
  EXPECT_EQ(SocketClient(port(), "Origin: http://evil.example\r\n").status(), 403);
  EXPECT_EQ(SocketClient(port(), "Origin: http://127.0.0.1:" + std::to_string(port()) + "\r\n").status(), 101);
}

TEST_F(ServerOf, GivesFilesWholeAndInParts) {
  EXPECT_EQ(get(port(), "/camera.bin").body, "0123456789");
  const Answer part = get(port(), "/camera.bin", "Range: bytes=2-4\r\n");
  EXPECT_EQ(part.status, 206);
  EXPECT_EQ(part.body, "234");
  EXPECT_EQ(get(port(), "/camera.bin", "Range: bytes=8-10\r\n").status, 416);
  EXPECT_EQ(get(port(), "/camera.bin", "Range: bytes=0-99999999999\r\n").status, 416);
  EXPECT_EQ(get(port(), "/camera.bin", "Range: bytes=4-2\r\n").body, "0123456789");
  folder.write("camera.bin", "0123456789abc");
  EXPECT_EQ(get(port(), "/camera.bin", "Range: bytes=8-10\r\n").body, "89a") << "it grows";
}

TEST_F(ServerOf, TellsTheHistoryAndWhatIsNew) {
  history.append(R"({"e":"start","t":0})");
  SocketClient page(port());
  ASSERT_EQ(page.status(), 101);
  EXPECT_EQ(page.read_until("start"),
            "{\"e\":\"pace\",\"live\":true,\"paused\":false,\"speed\":0.0}\n"
            "{\"e\":\"start\",\"t\":0}\n");
  history.append(R"({"e":"pose","t":1})");
  EXPECT_EQ(page.read_until("pose"), "{\"e\":\"pose\",\"t\":1}\n");
  EXPECT_EQ(server.watchers(), 1U);
}

TEST_F(ServerOf, PagesSetThePace) {
  {
    const SocketClient page(port());
    page.send(R"({"pause":true})");
    EXPECT_TRUE(soon([&] { return pace.state().paused; }));
    page.send(R"({"speed":4})");
    EXPECT_TRUE(soon([&] { return pace.state().speed == 4.0; }));
    SocketClient other(port());
    EXPECT_NE(other.read_until("4.0").find("\"paused\":true"), std::string::npos) << "the others are told";
    page.send(R"({"pause":false})");
    EXPECT_TRUE(soon([&] { return !pace.state().paused; }));
    page.send(R"({"step":true})");
    EXPECT_TRUE(soon([&] { return pace.state().paused; }));
  }
  EXPECT_TRUE(soon([&] { return server.watchers() == 0 && !pace.state().paused; })) << "nobody is there to go on";
}

TEST_F(ServerOf, RudeMessagesEndTheConnection) {
  for (const std::string& message :
       {std::string("hello"), std::string(R"({"speed":-1})"), std::string(R"({"speed":1e9})"),
        std::string(R"({"pause":1})"), std::string(R"({"a":{}})"), std::string("[]"),
        std::string(R"({"pause":true,"step":true})"), std::string(1000, '{'), std::string("\xff\xfe", 2)}) {
    const SocketClient page(port());
    ASSERT_EQ(page.status(), 101);
    page.send(message);
    EXPECT_TRUE(page.raw().is_closed()) << message.substr(0, 40);
  }
  const SocketClient binary(port());
  binary.send(R"({"pause":true})", 0x82);
  EXPECT_TRUE(binary.raw().is_closed());
  EXPECT_FALSE(pace.state().paused);
  EXPECT_TRUE(answers());
}

TEST_F(ServerOf, SlowPagesHoldUpNobody) {
  const SocketClient slow(port());
  SocketClient quick(port());
  ASSERT_EQ(slow.status(), 101);
  const std::string line = R"({"e":"log","t":1,"text":")" + std::string(2000, 'x') + "\"}";
  constexpr int kLines = 20000;  // 40 MB, far more than a socket holds
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < kLines; ++i) history.append(line);
  history.append("last");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 2s);
  const std::string all = quick.read_until("last");
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), kLines + 2);
  const std::size_t before = resident();
  for (int i = 0; i < 1000; ++i) history.append("x");
  EXPECT_LT(resident(), before + kFlat);
}

TEST_F(ServerOf, EndlessHeadersAreCutOff) {
  const std::size_t before = resident();
  const Client client(port());
  client.send("GET / HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port()) + "\r\nX-Endless: ");
  const std::string part(65536, 'a');
  std::size_t sent = 0;
  while (sent < (std::size_t{256} << 20) && client.send(part)) sent += part.size();
  EXPECT_LT(sent, std::size_t{32} << 20) << "what the sockets hold, no more";
  EXPECT_LT(resident(), before + kFlat);
  EXPECT_TRUE(answers());
}

TEST_F(ServerOf, AThousandConnectionsLeaveRoomForOne) {
  rlimit files_allowed{};
  ::getrlimit(RLIMIT_NOFILE, &files_allowed);
  files_allowed.rlim_cur = std::min<rlim_t>(files_allowed.rlim_max, 4096);
  ::setrlimit(RLIMIT_NOFILE, &files_allowed);
  const std::size_t before = resident();
  std::vector<Client> clients;
  for (int i = 0; i < 1000; ++i) {
    clients.emplace_back(port());
    ASSERT_TRUE(clients.back().is_open()) << i;
    clients.back().send("GET / HT");
  }
  EXPECT_TRUE(answers());
  EXPECT_LE(server.connections(), Server::kMostConnections);
  EXPECT_LT(resident(), before + kFlat);
  clients.clear();
  EXPECT_TRUE(soon([&] { return server.connections() == 0; }));
  EXPECT_TRUE(answers());
}

TEST_F(ServerOf, SocketsAreCounted) {
  std::vector<std::unique_ptr<SocketClient>> pages;
  for (std::size_t i = 0; i < Server::kMostSockets; ++i) {
    pages.push_back(std::make_unique<SocketClient>(port()));
    EXPECT_EQ(pages.back()->status(), 101);
  }
  EXPECT_EQ(SocketClient(port()).status(), 503);
  pages.clear();
  EXPECT_TRUE(soon([&] { return server.watchers() == 0; }));
  EXPECT_EQ(SocketClient(port()).status(), 101);
}

TEST_F(ServerOf, RubbishIsRefused) {
  RandomStream random(1, "test/rubbish");
  const std::size_t before = resident();
  for (int i = 0; i < 100; ++i) {
    std::string bytes(random.below(20000), '\0');
    for (char& c : bytes) c = static_cast<char>(random.below(256));
    const Client client(port());
    client.send(bytes);
    const SocketClient page(port());
    page.raw().send(bytes);
  }
  EXPECT_TRUE(answers());
  EXPECT_LT(resident(), before + kFlat);
}

TEST(Server, AsksForATokenWhereOthersCanReachIt) {
  History history;
  const auto refused = [&](const ServerOptions& options) {
    return test::sentence_of<ArgumentError>([&] { const Server server(options, {}, history, nullptr); });
  };
  EXPECT_NE(refused({"0.0.0.0", 0, ""}).find("--token"), std::string::npos);
  EXPECT_NE(refused({"127.0.0.1", 0, "short"}).find("8 to 128"), std::string::npos);
  EXPECT_NE(refused({"127.0.0.1", 0, "with a space"}).find("8 to 128"), std::string::npos);
  EXPECT_NE(refused({"nowhere", 0, ""}).find("IP address"), std::string::npos);
  const Server one({}, {}, history, nullptr);
  EXPECT_NE(refused({"127.0.0.1", one.port(), ""}).find("--port " + std::to_string(one.port())), std::string::npos);
}

TEST(Server, TakesAnotherPortWhereItMay) {
  History history;
  const Server one({}, {}, history, nullptr);
  const Server other({"127.0.0.1", one.port(), "", true}, {}, history, nullptr);
  EXPECT_NE(other.port(), one.port());
  EXPECT_EQ(get(other.port(), "/app.css").status, 200);
}

/// With the token alone nobody gets in who comes under a stranger's name.
TEST(Server, OpenToOthersItKnowsItsHosts) {
  History history;
  const Server server({"0.0.0.0", 0, "open-sesame"}, {}, history, nullptr);
  const std::string port = ":" + std::to_string(server.port());
  EXPECT_EQ(server.url().find("0.0.0.0"), std::string::npos);
  const auto status = [&](const std::string& host, const std::string& origin) {
    const std::string head = "GET / HTTP/1.1\r\nCookie: amiss_token=open-sesame\r\nConnection: close\r\nHost: ";
    return test::ask(server.port(), head + host + "\r\nOrigin: http://" + origin + "\r\n\r\n").status;
  };
  EXPECT_EQ(status("evil.example" + port, "evil.example" + port), 421);
  EXPECT_EQ(status("192.0.2.7" + port, "evil.example" + port), 403);
  EXPECT_EQ(status("192.0.2.7" + port, "192.0.2.7" + port), 200);
  EXPECT_EQ(status("127.0.0.1" + port, "127.0.0.1" + port), 200);
}

TEST(Server, TheTokenOpensIt) {
  History history;
  const Server server({"127.0.0.1", 0, "open-sesame"}, {}, history, nullptr);
  EXPECT_NE(server.url().find("/?token=open-sesame"), std::string::npos);
  EXPECT_EQ(get(server.port(), "/").status, 401);
  EXPECT_EQ(get(server.port(), "/?token=open-sesam").status, 401);
  EXPECT_EQ(SocketClient(server.port()).status(), 401);
  const Answer opened = get(server.port(), "/?token=open-sesame");
  EXPECT_EQ(opened.status, 303);
  EXPECT_NE(opened.head.find("Set-Cookie: amiss_token=open-sesame; HttpOnly; SameSite=Strict"), std::string::npos);
  EXPECT_EQ(get(server.port(), "/", "Cookie: amiss_token=open-sesame\r\n").status, 200);
  EXPECT_EQ(SocketClient(server.port(), "Cookie: amiss_token=open-sesame\r\n").status(), 101);
}

}  // namespace
}  // namespace amiss::page
