#include "page/guard.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace amiss::page {
namespace {

const Policy kPolicy{{"127.0.0.1:7474", "localhost:7474"}, 0, "", {"/", "/app.js", "/camera.bin"}, "/events"};

Request asked(std::string_view target) { return {"GET", target, "127.0.0.1:7474", "", "", "", false}; }
int status(const Request& request, const Policy& policy = kPolicy) { return judge(request, policy).status; }

TEST(Guard, AnswersWhatIsThere) {
  for (const char* route : {"/", "/app.js", "/camera.bin"}) {
    EXPECT_EQ(status(asked(route)), 200);
    EXPECT_EQ(judge(asked(route), kPolicy).route, route);
  }
  Request head = asked("/app.js");
  head.method = "HEAD";
  EXPECT_EQ(status(head), 200);
  EXPECT_EQ(status(asked("/events")), 426);
  Request socket = asked("/events");
  socket.upgrade = true;
  EXPECT_EQ(status(socket), 101);
}

TEST(Guard, MatchesRoutesExactly) {
  for (const char* target : {"/../etc/passwd", "/%2e%2e/etc/passwd", "/app.js/", "//app.js", "/APP.JS", "/app.js?x", "",
                             "/camera.bin/../status", "http://127.0.0.1:7474/", "*", "/..%2f..%2fparams.yaml", "/./"}) {
    EXPECT_EQ(status(asked(target)), 404) << target;
  }
  Request upgrade = asked("/app.js");
  upgrade.upgrade = true;
  EXPECT_EQ(status(upgrade), 404);
}

RC_GTEST_PROP(Guard, NoTargetOpensAnythingElse, (const std::string& tail)) {
  const Verdict verdict = judge(asked("/" + tail), kPolicy);
  RC_ASSERT((verdict.status == 200) == kPolicy.routes.contains("/" + tail));
}

TEST(Guard, RefusesOtherNamesOfTheServer) {
  for (const char* host : {"evil.example", "127.0.0.1", "127.0.0.1:7475", "127.0.0.1:7474.evil.example", "localhost"}) {
    Request request = asked("/");
    request.host = host;
    EXPECT_EQ(status(request), 421) << host;
  }
  Request nameless = asked("/");
  nameless.host = "";
  EXPECT_EQ(status(nameless), 400);
}

/// As seen from other machines: by its name and by addresses, which cannot be a stranger's name.
TEST(Guard, KnowsItsNameAndAddresses) {
  Policy policy = kPolicy;
  policy.hosts = {"kitchen:7474"};
  policy.port_of_literals = 7474;
  Request request = asked("/");
  for (const char* host : {"kitchen:7474", "Kitchen:7474", "192.0.2.7:7474", "127.0.0.1:7474", "[2001:db8::7]:7474",
                           "[::ffff:192.0.2.7]:7474"}) {
    request.host = host;
    EXPECT_EQ(status(request, policy), 200) << host;
  }
  for (const std::string_view host :
       {"evil.example:7474", "kitchen", "kitchen:7475", "192.0.2.7", "192.0.2.7:7475", "192.0.2.7.evil.example:7474",
        "192.0.2:7474", "0x7f000001:7474", "2001:db8::7:7474", "[2001:db8::7:7474", "[evil]:7474", "[]:7474", ":7474",
        "192.0.2.7:7474:7474", "192.0.2.7:07474"}) {
    request.host = host;
    EXPECT_EQ(status(request, policy), 421) << host;
  }
  request.host = std::string_view("192.0.2.7\0evil:7474", 19);
  EXPECT_EQ(status(request, policy), 421);
  request.host = "evil.example:7474";
  request.origin = "http://evil.example:7474";
  EXPECT_EQ(status(request, policy), 421) << "a stranger's name that leads here, and is its own Origin";
  policy.port_of_literals = 80;
  request.origin = "";
  request.host = "192.0.2.7";
  EXPECT_EQ(status(request, policy), 200) << "browsers leave out the port of HTTP";
}

TEST(Guard, RefusesOtherSites) {
  for (const char* origin : {"http://evil.example", "null", "https://127.0.0.1:7474", "http://localhost:7474"}) {
    Request socket = asked("/events");
    socket.upgrade = true;
    socket.origin = origin;
    EXPECT_EQ(status(socket), 403) << origin;
  }
  Request own = asked("/events");
  own.upgrade = true;
  own.origin = "http://127.0.0.1:7474";
  EXPECT_EQ(status(own), 101);

  Request picture = asked("/camera.bin");
  picture.fetch_site = "cross-site";
  EXPECT_EQ(status(picture), 403);
  Request link = asked("/");
  link.fetch_site = "cross-site";
  EXPECT_EQ(status(link), 200) << "a link to the page may stand anywhere";
}

TEST(Guard, ReadsOnly) {
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "CONNECT", "TRACE", "get", ""}) {
    Request request = asked("/");
    request.method = method;
    EXPECT_EQ(status(request), 405) << method;
  }
}

TEST(Guard, AsksForTheToken) {
  Policy policy = kPolicy;
  policy.token = "open-sesame";
  EXPECT_EQ(status(asked("/"), policy), 401);
  EXPECT_EQ(status(asked("/?token=open-sesam"), policy), 401);
  EXPECT_EQ(status(asked("/?token="), policy), 401);
  EXPECT_EQ(status(asked("/?token=open-sesame"), policy), 303);
  Request known = asked("/camera.bin");
  for (const char* cookie : {"amiss_token=open-sesame", "a=b; amiss_token=open-sesame; c=d"}) {
    known.cookie = cookie;
    EXPECT_EQ(status(known, policy), 200) << cookie;
  }
  for (const char* cookie :
       {"amiss_token=open-sesame2", "amiss_token", "xamiss_token=open-sesame", ";;;", "amiss_token="}) {
    known.cookie = cookie;
    EXPECT_EQ(status(known, policy), 401) << cookie;
  }
  Request socket = asked("/events");
  socket.upgrade = true;
  EXPECT_EQ(status(socket, policy), 401);
}

RC_GTEST_PROP(Guard, SecretsAreEqualOnlyToThemselves, (const std::string& a, const std::string& b)) {
  RC_ASSERT(same_secret(a, b) == (a == b));
  RC_ASSERT(same_secret(a, a));
}

}  // namespace
}  // namespace amiss::page
