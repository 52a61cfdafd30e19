// What the program says to wrong arguments and to inputs that cannot be read: a status and one sentence.
#include <gtest/gtest.h>

#include <algorithm>

#include "apps/program.hpp"
#include "core/random.hpp"
#include "mapping/voxel_files.hpp"

namespace amiss {
namespace {

namespace fs = std::filesystem;
using test::Ended;

const std::string kTop = AMISS_SOURCE_DIR;
const std::string kDomain = kTop + "/share/pddl/search.pddl";

struct Cli : testing::Test {
  test::TemporaryFolder folder;

  [[nodiscard]] Ended amiss(const std::vector<std::string>& arguments) const {
    return test::run(arguments, folder.path());
  }
  /// Refused with this status, nothing on standard output and one sentence that holds all these words.
  void expect_refusal(int status, const std::vector<std::string>& arguments,
                      const std::vector<std::string>& words) const {
    const Ended ended = amiss(arguments);
    std::string call;
    for (const std::string& word : arguments) call += " " + word;
    SCOPED_TRACE("amiss" + call + ": " + ended.err);
    EXPECT_EQ(ended.status, status);
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(ended.err.rfind("amiss: ", 0), 0U);
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1);
    for (const std::string& word : words) EXPECT_NE(ended.err.find(word), std::string::npos) << "without " << word;
  }
  /// The same for files that are cut short, zero or noise; `arguments` of a call for the file's name.
  template <class Arguments>
  void expect_broken_refused(const std::string& name, const std::string& whole, const Arguments& arguments) const {
    RandomStream random(1, name);
    std::string noise(2000, ' ');
    for (char& c : noise) c = static_cast<char>(random.below(256));
    for (const std::string& bytes :
         {std::string(), whole.substr(0, whole.size() / 2), std::string(whole.size(), '\0'), noise}) {
      expect_refusal(3, arguments(folder.write(name, bytes).string()), {name});
    }
    expect_refusal(3, arguments((folder.path() / "none").string() + "." + name), {"none." + name, "no such file"});
  }
};

std::string bytes_of(const fs::path& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

TEST_F(Cli, Version) {
  const Ended ended = amiss({"--version"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.out, "amiss " AMISS_VERSION "\n");
  EXPECT_EQ(ended.err, "");
}

TEST_F(Cli, HelpOfAllSubcommands) {
  EXPECT_EQ(amiss({"--help"}).status, 0);
  for (const char* subcommand : {"tidy", "map", "diff", "plan", "worlds", "objects"}) {
    const Ended ended = amiss({subcommand, "--help"});
    EXPECT_EQ(ended.status, 0) << subcommand;
    EXPECT_NE(ended.out.find("Usage"), std::string::npos) << subcommand;
    EXPECT_EQ(ended.err, "") << subcommand;
  }
}

TEST_F(Cli, Lists) {
  const Ended worlds = amiss({"worlds"}), objects = amiss({"objects"});
  EXPECT_EQ(worlds.status, 0);
  EXPECT_NE(worlds.out.find("lab_30"), std::string::npos);
  EXPECT_EQ(objects.status, 0);
  EXPECT_GE(std::count(objects.out.begin(), objects.out.end(), '\n'), 31) << "30 things and a heading";
}

TEST_F(Cli, SubcommandsAndOptions) {
  expect_refusal(2, {}, {"subcommand"});
  expect_refusal(2, {"tydi"}, {"did you mean 'tidy'?"});
  expect_refusal(2, {"tidy", "--sed", "3"}, {"--sed"});
  expect_refusal(2, {"tidy", "--objects", "-1"}, {"--objects", "0", "100"});
  expect_refusal(2, {"tidy", "--objects", "many"}, {"--objects"});
  expect_refusal(2, {"tidy", "--seed", "-1"}, {"--seed"});
  expect_refusal(2, {"tidy", "--until", "tired"}, {"--until", "found", "explored"});
  expect_refusal(2, {"tidy", "--time-limit", "nan"}, {"--time-limit"});
  expect_refusal(2, {"tidy", "--time-limit", "0"}, {"--time-limit"});
  expect_refusal(2, {"tidy", "--threads", "3"}, {"--threads"});
  expect_refusal(2, {"map"}, {"--world"});
  expect_refusal(2, {"diff", "a.ot"}, {"CURRENT"});
}

TEST_F(Cli, EnginesOfExperiments) {
  const std::string spec = kTop + "/share/experiments/small.yaml";
  const auto refused = [&](std::vector<std::string> more, const std::vector<std::string>& words) {
    more.insert(more.begin(), {"experiment", "run", spec, "--out", "out"});
    expect_refusal(2, more, words);
  };
  refused({"--engine", "pbs"}, {"--engine", "local", "slurm", "parallel"});
  refused({"--engine", "slurm", "--chunk", "0"}, {"--chunk", "1"});
  refused({"--chunk", "2"}, {"--chunk", "--engine slurm", "--engine parallel"});
  refused({"--print"}, {"--print", "--engine slurm"});
  refused({"--engine", "local", "--sbatch=--time=1"}, {"--sbatch", "--engine slurm"});
  refused({"--engine", "slurm", "--sshlogin", "node"}, {"--sshlogin", "--engine parallel"});
  EXPECT_FALSE(fs::exists(folder.path() / "out"));
}

TEST_F(Cli, ScriptsForSlurmAreShown) {
  const Ended ended = amiss({"experiment", "run", kTop + "/share/experiments/small.yaml", "--out", "out", "--engine",
                             "slurm", "--chunk", "4", "--sbatch=--partition=short", "--print"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.out.rfind("#!/bin/sh\n#SBATCH --job-name=amiss-", 0), 0U) << ended.out;
  EXPECT_NE(ended.out.find("#SBATCH --array=0-1\n"), std::string::npos);
  EXPECT_NE(ended.out.find("#SBATCH --partition=short\n"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(folder.path() / "out" / "trials"));
}

TEST_F(Cli, Worlds) {
  expect_refusal(2, {"tidy", "--world", "flat_9"}, {"there is no such world", "did you mean 'flat_90'?"});
  expect_refusal(2, {"map", "--world", "qqqqqqq"}, {"amiss worlds"});
  expect_broken_refused("w.sdf", bytes_of(kTop + "/sim_worlds/lab_30.sdf"), [](const std::string& file) {
    return std::vector<std::string>{"tidy", "--world", file};
  });
}

TEST_F(Cli, Parameters) {
  expect_refusal(2, {"tidy", "--set", "serch.look=1"}, {"serch.look", "did you mean 'search.look'?"});
  expect_refusal(2, {"tidy", "--set", "search.look=99"}, {"search.look", "'99'", "0.2 .. 10 s"});
  expect_refusal(2, {"tidy", "--set", "search.look=nan"}, {"'nan'", "0.2 .. 10 s"});
  expect_refusal(2, {"tidy", "--set", "search.look"}, {"key=value"});
  const std::string file = folder.write("p.yaml", "search:\n  look: 1\n  lock: 2\n");
  expect_refusal(2, {"tidy", "--params", file}, {"p.yaml:3", "search.lock", "search.look"});
  expect_refusal(2, {"tidy", "--params", folder.write("q.yaml", "search: {look: 1\n")}, {"q.yaml:", "not YAML"});
  expect_refusal(3, {"tidy", "--params", "none.yaml"}, {"none.yaml", "no such file"});
}

TEST_F(Cli, PrintedParametersAreReadBack) {
  const Ended first = amiss({"tidy", "--set", "search.look=1.25", "--print-params"});
  EXPECT_EQ(first.status, 0);
  const Ended second = amiss({"tidy", "--params", folder.write("p.yaml", first.out), "--print-params"});
  EXPECT_EQ(second.status, 0) << second.err;
  EXPECT_EQ(second.out, first.out);
  EXPECT_NE(first.out.find("look: 1.25"), std::string::npos);
}

TEST_F(Cli, Robots) {
  expect_broken_refused("r.urdf", bytes_of(kTop + "/robot_model/hsr.urdf"), [](const std::string& file) {
    return std::vector<std::string>{"tidy", "--world", "lab_30", "--robot", file};
  });
}

TEST_F(Cli, Scatter) {
  const auto call = [](const std::string& file) {
    return std::vector<std::string>{"tidy", "--world", "lab_30", "--scatter", file};
  };
  const auto refused = [&](const std::string& text, const std::vector<std::string>& words) {
    expect_refusal(3, call(folder.write("s.yaml", text)), words);
  };
  refused("- {object: lemon, x: 1, y: 1}\n- {object: lemmon, x: 1, y: 1}\n", {"s.yaml:2", "lemmon", "lemon"});
  refused("- {object: lemon, x: .nan, y: 1}\n", {"s.yaml:1", "x"});
  refused("- {object: lemon, x: 1}\n", {"s.yaml:1", "y is missing"});
  refused("objects: 5\n", {"s.yaml:1"});
  refused("- {object: lemon\n", {"s.yaml"});
  refused(std::string(100, '\0'), {"s.yaml"});
  expect_refusal(3, call("none.yaml"), {"none.yaml", "no such file"});
}

TEST_F(Cli, OutputFolderThatHoldsSomethingElse) {
  folder.write("dear.txt", "dear");
  expect_refusal(2, {"tidy", "--world", "lab_30", "--out", folder.path()}, {"holds something else"});
  expect_refusal(2, {"map", "--world", "lab_30", "--out", folder.path() / "dear.txt"}, {"is a file"});
  EXPECT_EQ(folder.read("dear.txt"), "dear");
  EXPECT_EQ(folder.count(), 1U);
}

constexpr const char* kProblem =
    "(define (problem p) (:domain search) (:objects hsr - robot a b - waypoint t - triangle)\n"
    "(:init (robot_at hsr a) (connected a b) (= (distance a b) 5) (= (total-cost) 0) (views b t))\n"
    "(:goal (explored t)) (:metric minimize (total-cost)))\n";

TEST_F(Cli, Plans) {
  const std::string problem = folder.write("p.pddl", kProblem);
  const Ended solved = amiss({"plan", kDomain, problem});
  EXPECT_EQ(solved.status, 0) << solved.err;
  EXPECT_NE(solved.out.find("(goto_waypoint hsr a b)"), std::string::npos);
  EXPECT_EQ(amiss({"plan", kDomain, problem, "--validate", folder.write("good.plan", solved.out)}).status, 0);
  const std::string wrong = folder.write("wrong.plan", "(explore_waypoint hsr b t)\n");
  const Ended invalid = amiss({"plan", kDomain, problem, "--validate", wrong});
  EXPECT_EQ(invalid.status, 1);
  EXPECT_NE(invalid.out.find("robot_at hsr b"), std::string::npos) << invalid.out;
  std::string unsolvable = kProblem;
  unsolvable.replace(unsolvable.find("(connected a b)"), 15, "");
  EXPECT_EQ(amiss({"plan", kDomain, folder.write("u.pddl", unsolvable)}).status, 1);
}

TEST_F(Cli, BrokenPddl) {
  const std::string problem = folder.write("good.pddl", kProblem);
  expect_broken_refused("d.pddl", bytes_of(kDomain), [&](const std::string& file) {
    return std::vector<std::string>{"plan", file, problem};
  });
  expect_broken_refused("p.pddl", kProblem, [](const std::string& file) {
    return std::vector<std::string>{"plan", kDomain, file};
  });
  std::string unknown = kProblem;
  unknown.replace(unknown.find("views b t"), 9, "sees  b t");
  expect_refusal(3, {"plan", kDomain, folder.write("x.pddl", unknown)}, {"x.pddl:2", "sees"});
}

TEST_F(Cli, BrokenMaps) {
  mapping::VoxelMap map;
  for (int x = 0; x < 20; ++x) map.set({x, 3, 0}, x % 2 == 0 ? Occupancy::kOccupied : Occupancy::kFree);
  const std::string good = voxel_map_bytes(map, mapping::VoxelFormat::kOt);
  const std::string whole = folder.write("whole.ot", good);
  EXPECT_EQ(amiss({"diff", whole, whole}).status, 0);
  expect_broken_refused("c.ot", good, [&](const std::string& file) {
    return std::vector<std::string>{"diff", whole, file};
  });
  expect_broken_refused("c.bt", good, [&](const std::string& file) {
    return std::vector<std::string>{"diff", file, whole};
  });
  expect_broken_refused("g.yaml", "image: g.pgm\nresolution: 0.05\n", [&](const std::string& file) {
    return std::vector<std::string>{"diff", whole, whole, "--grid", file};
  });
}

}  // namespace
}  // namespace amiss
