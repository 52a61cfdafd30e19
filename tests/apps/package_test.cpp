// The .deb that cpack makes of what was built: its fields, its files, and that they work where they are unpacked.
#include <array>
#include <cstdio>
#include <sstream>

#include "apps/program.hpp"

namespace amiss {
namespace {

namespace fs = std::filesystem;

/// What a shell command prints; a failure where it does not end well.
std::string output_of(const std::string& command) {
  std::string out;
  FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) out += buffer.data();
  EXPECT_EQ(::pclose(pipe), 0) << command << "\n" << out;
  return out;
}

std::string in_quotes(const fs::path& path) { return "'" + path.string() + "'"; }

struct Package : testing::Test {
  static void SetUpTestSuite() {
    if (std::system("command -v cpack >/dev/null && command -v dpkg-deb >/dev/null") != 0) return;
    folder = std::make_unique<test::TemporaryFolder>();
    const std::string config = in_quotes(AMISS_BUILD_DIR "/CPackConfig.cmake");
    output_of("cpack --config " + config + " -B " + in_quotes(folder->path()));
    for (const auto& entry : fs::directory_iterator(folder->path())) {
      if (entry.path().extension() == ".deb") deb = entry.path();
    }
  }
  static void TearDownTestSuite() { folder.reset(); }
  void SetUp() override {
    if (!folder) GTEST_SKIP() << "cpack or dpkg-deb is not installed";
    ASSERT_FALSE(deb.empty());
  }
  static std::unique_ptr<test::TemporaryFolder> folder;
  static fs::path deb;
};
std::unique_ptr<test::TemporaryFolder> Package::folder;
fs::path Package::deb;

TEST_F(Package, SaysWhatItIsAndNeeds) {
  const auto field = [](const std::string& name) { return output_of("dpkg-deb -f " + in_quotes(deb) + " " + name); };
  EXPECT_EQ(field("Package"), "amiss\n");
  EXPECT_EQ(field("Version"), AMISS_VERSION "\n");
  EXPECT_EQ(field("Section"), "science\n");
  EXPECT_EQ(field("Recommends"), "ffmpeg, gnuplot-nox | gnuplot\n");
  EXPECT_EQ(field("Suggests"), "bash-completion, parallel, slurm-client\n");
  for (const char* library :
       {"libmrpt-slam", "liboctomap", "libpcl-common", "libbullet", "libompl", "libosmesa", "libsdformat", "libc6"}) {
    EXPECT_NE(field("Depends").find(library), std::string::npos) << library;
  }
}

TEST_F(Package, HoldsTheProgramItsDataAndItsManual) {
  const std::string list = output_of("dpkg-deb -c " + in_quotes(deb));
  for (const char* file : {"bin/amiss", "share/amiss/sim_worlds/flat_90.sdf", "share/amiss/robot_model/hsr.urdf",
                           "share/amiss/objects/mug/", "share/amiss/pddl/search.pddl", "share/man/man1/amiss.1",
                           "share/bash-completion/completions/amiss", "share/zsh/vendor-completions/_amiss",
                           "share/doc/amiss/copyright"}) {
    EXPECT_NE(list.find(std::string(" ./usr/") + file + "\n"), std::string::npos) << file;
  }
  std::istringstream lines(list);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_NE(line.find(" ./usr/"), std::string::npos) << line;
    EXPECT_NE(line.find(" root/root "), std::string::npos) << line;
  }
}

TEST_F(Package, WorksWhereItIsUnpacked) {
  const fs::path root = folder->path() / "root";
  output_of("dpkg-deb -x " + in_quotes(deb) + " " + in_quotes(root));
  const std::string said = output_of(in_quotes(root / "usr/bin/amiss") + " doctor");
  EXPECT_NE(said.find((root / "usr/share/amiss").string() + "\n"), std::string::npos) << "its own data\n" << said;
  EXPECT_NE(said.find("amiss can run here"), std::string::npos) << said;
}

}  // namespace
}  // namespace amiss
