// What helps a user to begin: doctor, init, completion of the shells, the man page.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <sstream>

#include "apps/program.hpp"

namespace amiss {
namespace {

namespace fs = std::filesystem;
using test::Ended;

struct Setup : testing::Test {
  test::TemporaryFolder folder;

  [[nodiscard]] Ended amiss(const std::vector<std::string>& arguments) const {
    return test::run(arguments, folder.path());
  }
  /// What a shell prints for a script.
  [[nodiscard]] std::string shell(const std::string& call, const std::string& script) const {
    std::ofstream(folder.path() / "script") << script;
    std::string out;
    FILE* pipe = ::popen(("cd '" + folder.path().string() + "' && " + call + " script 2>&1").c_str(), "r");
    std::array<char, 4096> buffer{};
    while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) out += buffer.data();
    EXPECT_EQ(::pclose(pipe), 0) << out;
    return out;
  }
  [[nodiscard]] static bool has(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
  }
  /// What bash offers for these words, the last of which is being typed.
  [[nodiscard]] std::string bash_offers(const std::vector<std::string>& words) const {
    std::ofstream(folder.path() / "amiss.bash") << amiss({"completion", "bash"}).out;
    std::string line = "'" AMISS_PROGRAM "'";
    for (const std::string& word : words) line += " '" + word + "'";
    return shell("bash --norc", "source ./amiss.bash; COMP_WORDS=(" + line + "); COMP_CWORD=" +
                                    std::to_string(words.size()) + "; _amiss; echo \"${COMPREPLY[*]}\"");
  }
  /// The same of zsh: what the functions of its completion system are called with.
  [[nodiscard]] std::string zsh_offers(const std::vector<std::string>& words) const {
    std::ofstream(folder.path() / "_amiss") << amiss({"completion", "zsh"}).out;
    std::string line = "'" AMISS_PROGRAM "'";
    for (const std::string& word : words) line += " '" + word + "'";
    return shell("zsh -f",
                 "compadd() { echo \"$@\" }; _files() { echo FILES \"$@\" }; _message() { echo MESSAGE }\n"
                 "_describe() { print -l -- ${(P)@[-1]} }\n"
                 "words=(" +
                     line + "); CURRENT=" + std::to_string(words.size() + 1) + "; source ./_amiss");
  }
};

TEST_F(Setup, DoctorSaysWhatIsThere) {
  const Ended ended = amiss({"doctor"});
  EXPECT_EQ(ended.status, 0) << ended.out;
  EXPECT_EQ(ended.err, "");
  for (const char* word : {AMISS_VERSION, "cores", "worlds", "GB free", "OpenGL", "MRPT 2.", "OctoMap 1.", "PCL 1.",
                           "Bullet 3.", "OMPL 1.", "Slurm", "amiss can run here"}) {
    EXPECT_NE(ended.out.find(word), std::string::npos) << word << "\n" << ended.out;
  }
}

TEST_F(Setup, DoctorIsOneWhereSomethingIsMissing) {
  ::setenv("AMISS_SHARE", (folder.path() / "nowhere").c_str(), 1);
  const Ended ended = amiss({"doctor"});
  ::unsetenv("AMISS_SHARE");
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.out.find("BAD  data"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("nowhere"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("amiss cannot run here"), std::string::npos) << ended.out;
}

TEST_F(Setup, WhatInitMakesRunsAsItIs) {
  ASSERT_EQ(amiss({"init", "home"}).status, 0);
  const Ended scenario = amiss({"scenario", "home/scenario.yaml", "--prove"});
  EXPECT_EQ(scenario.status, 0) << scenario.out << scenario.err;
  EXPECT_NE(scenario.out.find("2 of 2 as expected"), std::string::npos) << scenario.out;
  const Ended tidy = amiss({"tidy", "--world", "home/room.sdf", "--params", "home/params.yaml", "--objects", "1",
                            "--out", "run", "--quiet"});
  EXPECT_EQ(tidy.status, 0) << tidy.out << tidy.err;
}

TEST_F(Setup, InitTouchesNothingThatIsThere) {
  folder.write("dear.txt", "dear");
  const Ended ended = amiss({"init", "."});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("empty folder is needed"), std::string::npos) << ended.err;
  EXPECT_EQ(folder.count(), 1U);
}

TEST_F(Setup, BashCompletes) {
  EXPECT_EQ(bash_offers({"tid"}), "tidy\n");
  EXPECT_EQ(bash_offers({"experiment", "st"}), "status\n");
  EXPECT_EQ(bash_offers({"tidy", "--scatter"}), "--scatter --scatter-seed\n");
  EXPECT_EQ(bash_offers({"tidy", "--method", ""}), "dynamic static\n");
  EXPECT_EQ(bash_offers({"map", "--world", "la"}), "lab_30\n");
  EXPECT_EQ(bash_offers({"tidy", "--set", "change.min_v"}), "change.min_voxels=\n");
  folder.write("p1.pddl", "");
  EXPECT_EQ(bash_offers({"plan", "p1"}), "p1.pddl\n");
  fs::create_directory(folder.path() / "runs1");
  EXPECT_EQ(bash_offers({"view", "runs"}), "runs1\n");
  EXPECT_EQ(bash_offers({"tidy", "--seed", ""}), "\n");
}

TEST_F(Setup, ZshCompletes) {
  if (!has("zsh")) GTEST_SKIP() << "zsh is not installed";
  EXPECT_NE(zsh_offers({"tid"}).find("tidy:search a flat"), std::string::npos);
  EXPECT_NE(zsh_offers({"experiment", ""}).find("status:what is done"), std::string::npos);
  EXPECT_NE(zsh_offers({"tidy", "--s"}).find("--scatter-seed:of what"), std::string::npos);
  EXPECT_EQ(zsh_offers({"tidy", "--method", ""}), "-- dynamic static\n");
  EXPECT_NE(zsh_offers({"map", "--world", ""}).find(" lab_30 "), std::string::npos);
  EXPECT_NE(zsh_offers({"tidy", "--set", ""}).find(" change.min_voxels "), std::string::npos);
  EXPECT_EQ(zsh_offers({"plan", ""}), "FILES\n");
  EXPECT_EQ(zsh_offers({"view", ""}), "FILES -/\n");
}

TEST_F(Setup, TheManPageHoldsEveryOptionAndParameter) {
  const std::string page = amiss({"man"}).out;
  for (const char* text :
       {"\\fBamiss tidy\\fR", "\\fB\\-\\-scatter\\-seed\\fR \\fIUINT\\fR", "\\fBchange.min_voxels\\fR = 2",
        "\\fB130\\fR\ninterrupted", "\\fBdynamic\\fR|\\fBstatic\\fR"}) {
    EXPECT_NE(page.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(page.find("\\-\\-child"), std::string::npos) << "hidden options stay hidden";
  if (!has("groff")) GTEST_SKIP() << "groff is not installed: whether the page is good roff was not checked";
  std::ofstream(folder.path() / "amiss.1") << page;
  const std::string warnings = shell("sh", "groff -man -Tutf8 -ww amiss.1 >text");
  EXPECT_EQ(warnings, "");
  EXPECT_NE(folder.read("text").find("search a flat for what lies"), std::string::npos);
}

TEST_F(Setup, TheNearestIsOfferedAtEveryLevel) {
  const auto said = [&](const std::vector<std::string>& arguments) { return amiss(arguments).err; };
  EXPECT_NE(said({"docter"}).find("did you mean 'doctor'?"), std::string::npos);
  EXPECT_NE(said({"experiment", "statsu", "x"}).find("did you mean 'status'?"), std::string::npos);
  EXPECT_NE(said({"tidy", "--objcts", "3"}).find("did you mean '--objects'?"), std::string::npos);
  EXPECT_NE(said({"tidy", "--objcts=3"}).find("did you mean '--objects'?"), std::string::npos);
  EXPECT_EQ(said({"tidy", "--seed", "x"}).find("did you mean"), std::string::npos);
}

}  // namespace
}  // namespace amiss
