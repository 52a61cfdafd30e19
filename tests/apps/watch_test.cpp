// Pages of a run that goes on and of one that is over, asked as a browser asks, and by clients that are rude.
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "page/http_client.hpp"
#include "program.hpp"

namespace amiss {
namespace {

using nlohmann::json;
using test::Ended;
using test::Program;

const std::vector<std::string> kRun{"tidy", "--world", "lab_30",   "--objects",    "3",  "--seed",
                                    "7",    "--until", "explored", "--time-limit", "20", "--json"};

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// The port that the program told, or 0 when it ended before.
int port_of(const Program& program) {
  const std::string before = "watch at http://127.0.0.1:";
  for (int i = 0; i < 6000 && program.runs(); ++i) {
    const std::string said = program.said();
    const std::size_t at = said.find(before);
    if (at != std::string::npos && said.find('\n', at) != std::string::npos)
      return std::stoi(said.substr(at + before.size()));
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return 0;
}

/// True when it says that on standard error within a minute.
bool says(const Program& program, const std::string& text) {
  for (int i = 0; i < 6000 && program.said().find(text) == std::string::npos && program.runs(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return program.said().find(text) != std::string::npos;
}

constexpr long kFlat_kb = 32 << 10;

/// A thousand connections with rubbish at once, headers without end, rubbish on an open socket, and what is forbidden.
void be_rude(int port) {
  rlimit files{};
  ::getrlimit(RLIMIT_NOFILE, &files);
  files.rlim_cur = std::min<rlim_t>(files.rlim_max, 4096);
  ::setrlimit(RLIMIT_NOFILE, &files);
  std::vector<test::Client> many;
  for (int i = 0; i < 1000; ++i) {
    many.emplace_back(port);
    ASSERT_TRUE(many.back().is_open()) << i;
    many.back().send(std::string(1000, static_cast<char>(i)));
  }
  const std::string host = "Host: 127.0.0.1:" + std::to_string(port) + "\r\n", part(65536, 'a');
  const test::Client endless(port);
  endless.send("GET / HTTP/1.1\r\n" + host + "X-Endless: ");
  std::size_t sent = 0;
  while (sent < std::size_t{256} << 20 && endless.send(part)) sent += part.size();
  EXPECT_LT(sent, std::size_t{32} << 20);
  const test::SocketClient socket(port);
  EXPECT_EQ(socket.status(), 101);
  socket.raw().send(std::string(100000, '\xff'));
  EXPECT_TRUE(socket.raw().is_closed());
  EXPECT_EQ(test::get(port, "/../../etc/passwd").status, 404);
  EXPECT_EQ(test::ask(port, "GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n").status, 421);
  EXPECT_EQ(test::SocketClient(port, "Origin: http://evil.example\r\n").status(), 403);
}

/// A film needs the run folder and the world that it names, nothing else.
void expect_film(const std::filesystem::path& folder, const std::string& run) {
  const Ended made =
      test::run({"video", run, "--out", "film.mp4", "--speed", "20", "--fps", "5", "--width", "320"}, folder);
  if (std::system("command -v ffmpeg >/dev/null && command -v ffprobe >/dev/null") != 0) {
    EXPECT_NE(made.status, 0);
    EXPECT_NE(made.err.find("ffmpeg"), std::string::npos) << made.err;
    return;
  }
  ASSERT_EQ(made.status, 0) << made.err;
  const Ended nowhere = test::run({"video", run, "--out", "nowhere/film.mp4", "--speed", "20"}, folder);
  EXPECT_NE(nowhere.status, 0);
  EXPECT_EQ(nowhere.err.find("amiss: nowhere/film.mp4: ffmpeg could not write it: "), 0U) << nowhere.err;
  EXPECT_EQ(nowhere.err.find('\n') + 1, nowhere.err.size()) << "one sentence: " << nowhere.err;
  const std::string probe = "ffprobe -v error -show_entries stream=width,height,duration -of csv=p=0 '" +
                            (folder / "film.mp4").string() + "' > '" + (folder / "probed").string() + "'";
  ASSERT_EQ(std::system(probe.c_str()), 0);
  std::string probed;
  std::getline(std::ifstream(folder / "probed"), probed);
  EXPECT_EQ(probed, "320,180,1.200000") << "20 s and both ends, 20 times as fast";
}

/// A scene needs the run folder alone.
void expect_scene(const std::filesystem::path& folder, const std::string& run) {
  const Ended made = test::run({"scene", run, "--out", "end.3Dscene", "--at", "15"}, folder);
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(made.out, "end.3Dscene\n");
  EXPECT_GT(std::filesystem::file_size(folder / "end.3Dscene"), 10'000U);
  const Ended late = test::run({"scene", run, "--out", "late.3Dscene", "--at", "99"}, folder);
  EXPECT_EQ(late.status, 2);
  EXPECT_NE(late.err.find("--at is behind the end"), std::string::npos) << late.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "late.3Dscene"));
}

TEST(Watch, WatchedAndPesteredARunGivesTheSameDigest) {
  const test::TemporaryFolder folder;
  const Ended alone = test::run(with(kRun, {"--out", "alone"}), folder.path());
  ASSERT_LE(alone.status, 1) << alone.err;

  Program program(with(kRun, {"--out", "watched", "--view", "--port", "0"}), folder.path());
  const int port = port_of(program);
  ASSERT_GT(port, 0);
  std::string seen;
  {
    test::SocketClient page(port);
    const test::SocketClient slow(port);  // never reads
    be_rude(port);
    page.send(R"({"pause":true})");
    page.send(R"({"step":true})");
    page.send(R"({"pause":false})");
    seen = page.read_until("\"e\":\"end\"");
    EXPECT_TRUE(says(program, "the run is over; close its page or press Ctrl+C\n"));
  }
  const Ended watched = program.wait();
  EXPECT_EQ(watched.status, alone.status) << watched.err;
  EXPECT_LT(watched.peak_kb, alone.peak_kb + kFlat_kb);
  const json a = json::parse(alone.out), b = json::parse(watched.out);
  EXPECT_EQ(a["digest"], b["digest"]);
  for (const char* kind : {"start", "pose", "frame", "voxels", "regions", "plan"}) {
    EXPECT_NE(seen.find(std::string("{\"e\":\"") + kind), std::string::npos) << kind;
  }
  EXPECT_EQ(folder.read("alone/camera.bin"), folder.read("watched/camera.bin"));
  const auto without_end = [](const std::string& lines) { return lines.substr(0, lines.rfind("{\"e\":\"end\"")); };
  EXPECT_EQ(without_end(folder.read("alone/timeline.jsonl")), without_end(folder.read("watched/timeline.jsonl")));
  const std::string report = folder.read("alone/report.html");
  EXPECT_NE(report.find("id=\"run\""), std::string::npos);
  EXPECT_LT(report.size(), 3'000'000U);

  Program view({"view", "alone", "--port", "0"}, folder.path());
  const int again = port_of(view);
  ASSERT_GT(again, 0);
  EXPECT_NE(test::SocketClient(again).read_until("\"e\":\"end\"").find("\"live\":false"), std::string::npos);
  EXPECT_EQ(test::get(again, "/timeline.jsonl").body, folder.read("alone/timeline.jsonl"));
  EXPECT_EQ(test::get(again, "/knowledge.sqlite").status, 404);
  view.send(SIGINT);
  EXPECT_EQ(view.wait().status, 0);
  expect_film(folder.path(), "alone");
  expect_scene(folder.path(), "alone");
  std::string moved = folder.read("alone/timeline.jsonl");
  const std::string place = R"("place":{"world":"lab_30")";
  ASSERT_NE(moved.find(place), std::string::npos);
  std::filesystem::create_directory(folder.path() / "moved");
  folder.write("moved/timeline.jsonl",
               moved.replace(moved.find(place), place.size(), R"("place":{"world":"/gone/x.sdf")"));
  const Ended gone = test::run({"video", "moved", "--out", "film.mp4"}, folder.path());
  EXPECT_NE(gone.status, 0);
  EXPECT_NE(gone.err.find("--world says where it is now"), std::string::npos) << gone.err;
}

struct ViewOf : testing::Test {
  test::TemporaryFolder folder;
  void SetUp() override { folder.write("timeline.jsonl", "{\"e\":\"start\",\"t\":0,\"schema\":1}\n"); }
};

TEST_F(ViewOf, APortThatIsTakenIsAnErrorOnlyWhereItWasAskedFor) {
  const Program first({"view", "."}, folder.path());  // holds port 7474, where nobody else does
  ASSERT_GT(port_of(first), 0);
  const Program second({"view", "."}, folder.path());
  const int other = port_of(second);
  ASSERT_GT(other, 0);
  EXPECT_NE(other, 7474);
  EXPECT_NE(second.said().find("amiss: port 7474 is taken, so the page is at " + std::to_string(other) + "\n"),
            std::string::npos)
      << second.said();
  EXPECT_EQ(test::get(other, "/").status, 200);
  EXPECT_TRUE(says(second, "amiss: Ctrl+C ends it\n"));
  const Ended refused = test::run({"view", ".", "--port", std::to_string(other)}, folder.path());
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("--port " + std::to_string(other) + " of 127.0.0.1: Address already in use"),
            std::string::npos)
      << refused.err;
}

TEST_F(ViewOf, ATokenCanComeFromTheEnvironment) {
  ::setenv("AMISS_TOKEN", "open-sesame", 1);
  const Program program({"view", ".", "--port", "0"}, folder.path());
  ::unsetenv("AMISS_TOKEN");
  const int port = port_of(program);
  ASSERT_GT(port, 0);
  EXPECT_EQ(test::get(port, "/").status, 401);
  EXPECT_EQ(test::get(port, "/", "Cookie: amiss_token=open-sesame\r\n").status, 200);
  EXPECT_NE(test::run({"view", "--help"}, folder.path()).out.find("AMISS_TOKEN"), std::string::npos);
}

/// A browser that takes its time and talks: nobody waits for it, and it gets none of the program's files.
TEST(Watch, ABrowserIsOpenedAndLeftAlone) {
  if (std::system("command -v script >/dev/null") != 0) GTEST_SKIP() << "script is not installed: no terminal";
  if (!test::has_terminals()) GTEST_SKIP() << "there are no pseudo-terminals here";
  const test::TemporaryFolder folder;
  const std::string here = folder.path().string();
  folder.write("xdg-open",
               "#!/bin/sh\necho noise\necho noise >&2\ncd '" + here +
                   "'\nls -l /proc/$$/fd >files\necho $$ >child\nprintf %s \"$1\" >opened\nexec sleep 600\n");
  std::filesystem::permissions(folder.path() / "xdg-open", std::filesystem::perms::owner_all);
  test::use_test_cache();
  std::string words;
  for (const std::string& word : with(kRun, {"--out", "run", "--view", "--port", "0"})) words += " " + word;
  const std::string call = "cd '" + here + "' && DISPLAY=:99 PATH='" + here + "':\"$PATH\" timeout 300 script -qec '" +
                           AMISS_PROGRAM + words + " >out' said </dev/null >/dev/null";
  const int status = std::system(call.c_str());
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) <= 1) << folder.read("said");
  EXPECT_EQ(std::system(("kill " + folder.read("child")).c_str()), 0) << "it was still there";
  EXPECT_EQ(json::parse(folder.read("out"))["seed"], 7) << "report.json and nothing else";
  const std::string said = folder.read("said"), files = folder.read("files");
  EXPECT_NE(said.find("watch at " + folder.read("opened")), std::string::npos) << said;
  EXPECT_EQ(said.find("noise"), std::string::npos);
  EXPECT_EQ(files.find("socket:"), std::string::npos) << files;
  EXPECT_EQ(files.find("timeline"), std::string::npos) << files;
  EXPECT_NE(files.find("0 -> /dev/null"), std::string::npos) << files;
}

TEST(Watch, RefusesWhatItCannotShow) {
  const test::TemporaryFolder folder;
  const Ended missing = test::run({"view", "nowhere"}, folder.path());
  EXPECT_EQ(missing.status, 3);
  EXPECT_NE(missing.err.find("timeline.jsonl: is not there"), std::string::npos);
  const Ended film = test::run({"video", "nowhere", "--out", "film.mp4"}, folder.path());
  EXPECT_EQ(film.status, 3);
  EXPECT_NE(film.err.find("timeline.jsonl: is not there"), std::string::npos);
  const Ended scene = test::run({"scene", "nowhere", "--out", "a.3Dscene"}, folder.path());
  EXPECT_EQ(scene.status, 3);
  EXPECT_NE(scene.err.find("timeline.jsonl: is not there"), std::string::npos);
  EXPECT_EQ(test::run({"scene", "nowhere", "--out", "a.ply"}, folder.path()).status, 2);
  folder.write("timeline.jsonl", "{\"e\":\"start\",\"t\":0,\"schema\":1}\n");
  for (const char* command : {"video", "scene"}) {
    const Ended old =
        test::run({command, ".", "--out", command == std::string("video") ? "a.mp4" : "a.3Dscene"}, folder.path());
    EXPECT_EQ(old.status, 3);
    EXPECT_NE(old.err.find("timeline.jsonl:1: does not say where the run took place"), std::string::npos) << old.err;
  }
  const Ended open = test::run({"view", ".", "--address", "0.0.0.0"}, folder.path());
  EXPECT_EQ(open.status, 2);
  EXPECT_NE(open.err.find("--token"), std::string::npos);
}

}  // namespace
}  // namespace amiss
