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
  /// What stands in the line of a zsh after these keys and a tab, with its own completion system (compinit).
  [[nodiscard]] std::string zsh_makes(const std::string& keys) const {
    std::ofstream(folder.path() / "_amiss") << amiss({"completion", "zsh"}).out;
    const std::string script =
        "zmodload zsh/zpty || exit 3\n"
        "zpty shell zsh -f -i\n"
        "zpty -w shell \"PS1=; path=('" +
        fs::path(AMISS_PROGRAM).parent_path().string() +
        "' \\$path); fpath=($PWD \\$fpath); autoload -Uz compinit; compinit -u -D\"\n"
        "zpty -w shell 'told() { print -rn -- \"$BUFFER\" >line.new; mv line.new line; BUFFER=; zle .accept-line }'\n"
        "zpty -w shell \"zle -N told; bindkey '^X' told; print READY\"\n"
        "zpty -r -m shell seen '*READY*READY*'\n"
        "zpty -n -w shell '" +
        keys +
        "'$'\\t\\x18'\n"
        "for i in {1..200}; do [[ -e line ]] && break; sleep 0.05; done\n"
        "zpty -d shell; cat line; rm line\n";
    return shell("timeout 60 zsh -f", script);
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
  for (const char* word :
       {AMISS_VERSION, "cores", "worlds", "GB free", "OpenGL", "MRPT 2.", "OctoMap 1.", "PCL 1.", "Bullet 3.",
        "OMPL 1.", "ffmpeg", "gnuplot", "GNU parallel", "Slurm", "amiss can run here"}) {
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

/// Of moreutils' parallel, which is another program, it must not say that it is GNU's.
TEST_F(Setup, DoctorKnowsWhatItCanDoWithout) {
  fs::create_directory(folder.path() / "bin");
  folder.write("bin/parallel", "#!/bin/sh\nexit 0\n");
  fs::create_symlink("/bin/sh", folder.path() / "bin/sh");
  fs::permissions(folder.path() / "bin/parallel", fs::perms::owner_all);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", (folder.path() / "bin").c_str(), 1);
  const Ended ended = amiss({"doctor"});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(ended.status, 0) << ended.out;
  for (const char* line : {"-    ffmpeg       not installed", "-    gnuplot      not installed",
                           "-    GNU parallel not installed", "-    Slurm        not installed"}) {
    EXPECT_NE(ended.out.find(line), std::string::npos) << line << "\n" << ended.out;
  }
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
  EXPECT_EQ(bash_offers({"completion", ""}), "bash zsh\n");
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

TEST_F(Setup, ZshCompletesWhatIsTyped) {
  if (!has("zsh")) GTEST_SKIP() << "zsh is not installed";
  if (!test::has_terminals()) GTEST_SKIP() << "there are no pseudo-terminals here";
  EXPECT_EQ(zsh_makes("amiss doc"), "amiss doctor ");
  EXPECT_EQ(zsh_makes("amiss experiment stat"), "amiss experiment status ");
  EXPECT_EQ(zsh_makes("amiss tidy --meth"), "amiss tidy --method ");
  EXPECT_EQ(zsh_makes("amiss map --world la"), "amiss map --world lab_30 ");
  EXPECT_EQ(zsh_makes("amiss tidy --set change.min_v"), "amiss tidy --set change.min_voxels=");
  fs::create_directory(folder.path() / "runs1");
  EXPECT_EQ(zsh_makes("amiss view runs"), "amiss view runs1/");
}

/// As a user has it: the line typed, and the tab.
TEST_F(Setup, BashCompletesWhatIsTyped) {
  std::ofstream(folder.path() / "amiss.bash") << amiss({"completion", "bash"}).out;
  const auto made = [&](const std::string& keys) {
    const std::string program = fs::path(AMISS_PROGRAM).parent_path().string();
    folder.write("rc", "PS1=\nset +o history\nPATH='" + program +
                           "':$PATH\nbind 'set enable-bracketed-paste off'\n"
                           "source ./amiss.bash\ntold() { printf %s \"$READLINE_LINE\" >line; READLINE_LINE=; }\n"
                           "bind -x '\"\\C-xt\": told'\n");
    folder.write("keys", keys + "\t\x18t\nexit\n");
    (void)shell("timeout 20 sh", "bash --rcfile rc -i <keys >seen 2>&1 || true\n");
    return folder.read("line");
  };
  EXPECT_EQ(made("amiss doc"), "amiss doctor ");
  EXPECT_EQ(made("amiss tidy --meth"), "amiss tidy --method ");
  EXPECT_EQ(made("amiss map --world la"), "amiss map --world lab_30 ");
  EXPECT_EQ(made("amiss tidy --set change.min_v"), "amiss tidy --set change.min_voxels=");
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

TEST_F(Setup, WhatIsWrongIsSaidInOneSentence) {
  const auto said = [&](const std::vector<std::string>& arguments) {
    const Ended ended = amiss(arguments);
    EXPECT_EQ(ended.status, 2) << ended.err;
    return ended.err;
  };
  EXPECT_EQ(said({"tdy"}), "amiss: amiss has no subcommand 'tdy'; did you mean 'tidy'?\n");
  EXPECT_EQ(said({}).find("amiss: amiss needs one of its subcommands: tidy, experiment, "), 0U);
  EXPECT_EQ(said({"experiment"}),
            "amiss: amiss experiment needs one of its subcommands: plan, run, work, status, merge, plot, verify\n");
  EXPECT_EQ(said({"dataset", "zzzzzzzz"}),
            "amiss: amiss dataset has no subcommand 'zzzzzzzz'; there are: make, annotate\n");
  EXPECT_EQ(said({"tidy", "--wrld", "flat_90"}), "amiss: `amiss tidy` has no option --wrld; did you mean '--world'?\n");
  EXPECT_EQ(said({"doctor", "--q"}), "amiss: `amiss doctor` has no option --q; `amiss doctor --help` lists them\n");
  EXPECT_EQ(said({"tidy", "--method", "dynamc"}),
            "amiss: --method dynamc is not allowed; did you mean 'dynamic'? Allowed: dynamic, static\n");
  EXPECT_EQ(said({"tidy", "--method=zzz"}), "amiss: --method zzz is not allowed. Allowed: dynamic, static\n");
  EXPECT_EQ(said({"completion", "fish"}), "amiss: completion fish: there are scripts for bash and zsh\n");
  EXPECT_EQ(said({"tidy", "--world", "flat90"}),
            "amiss: --world flat90: there is no such world; did you mean 'flat_90'?\n");
  EXPECT_EQ(said({"tidy", "--set", "change.min_voxel=3"}),
            "amiss: --set: there is no parameter 'change.min_voxel'; did you mean 'change.min_voxels'?\n");
  folder.write("p.yaml", "change:\n  min_voxel: 3\n");
  EXPECT_EQ(said({"tidy", "--params", "p.yaml"}),
            "amiss: p.yaml:2: there is no parameter 'change.min_voxel'; did you mean 'change.min_voxels'?\n");
}

}  // namespace
}  // namespace amiss
