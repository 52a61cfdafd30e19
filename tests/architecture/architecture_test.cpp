// The rules of the house, checked in the sources themselves. The table of libs/README.md is what is held against them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path kTop = AMISS_SOURCE_DIR;
constexpr std::ptrdiff_t kMostLines = 300;

/// Sources that other tests than those of their own name cover: why each of them may.
const std::map<std::string, std::string> kTestedBy = {
    // One class in several files.
    {"mapping/voxel_map_queries", "mapping/voxel_map_test.cpp"},
    {"mapping/surface_map_queries", "mapping/surface_map_test.cpp"},
    {"sim/scatter_file", "sim/scatter_test.cpp"},
    {"scenario/scenario_text", "scenario/scenario_file_test.cpp"},
    {"view/head_of", "view/head_test.cpp"},
    {"world/texture", "world/mesh_file_test.cpp"},
    // The two halves of one header.
    {"dataset/pcd_file", "dataset/cloud_files_test.cpp"},
    {"dataset/ply_file", "dataset/cloud_files_test.cpp"},
    // The tables of one header.
    {"training/seats", "training/furniture_test.cpp"},
    {"training/storage", "training/furniture_test.cpp"},
    {"training/decoration", "training/furniture_test.cpp"},
    {"training/props", "training/furniture_test.cpp"},
    // The planner's tests solve, print and check the same problems.
    {"plan/problem", "plan/problems_test.cpp"},
    {"plan/problem_text", "plan/problems_test.cpp"},
    {"plan/validator", "plan/plan_test.cpp"},
    {"sim/collision_log", "sim/physics_test.cpp"},
    // They need a robot that moves and sees: whole runs with the simulator.
    {"mission/perception", "apps/tidy_test.cpp"},
    {"mission/navigator", "apps/tidy_test.cpp"},
    {"mission/search_method", "apps/tidy_test.cpp"},
    {"mission/search", "apps/tidy_test.cpp"},
    {"mission/static_search", "apps/tidy_test.cpp"},
    {"mission/search_views", "apps/tidy_test.cpp"},
    {"mission/mapping_run", "apps/tidy_test.cpp"},
    {"recording/replay", "apps/record_test.cpp"},
    // It needs bags that ROS wrote.
    {"recording/bag_source", "apps/replay_bag_test.cpp"},
    {"mission/tour", "apps/dataset_make_test.cpp"},
};

struct Row {
  std::string library;
  std::set<std::string> may_include;
};

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream stream(file);
  EXPECT_TRUE(stream) << file;
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// "| core | what | robot world | third party |"
std::vector<Row> stage_table() {
  std::vector<Row> rows;
  for (const std::string& line : lines_of(kTop / "libs" / "README.md")) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, '|');) cells.push_back(cell);
    if (cells.size() != 5 || words(cells[1]).size() != 1 || words(cells[1])[0] == "library") continue;
    if (words(cells[1])[0].front() == '-') continue;
    const auto allowed = words(cells[3]);
    rows.push_back({words(cells[1])[0], {allowed.begin(), allowed.end()}});
    rows.back().may_include.erase("-");
  }
  return rows;
}

std::vector<fs::path> sources_below(const fs::path& folder) {
  std::vector<fs::path> sources;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".cpp" || extension == ".hpp") sources.push_back(entry.path());
  }
  std::sort(sources.begin(), sources.end());
  return sources;
}

struct Include {
  std::string what;
  bool quoted = false;
};

std::vector<Include> includes_of(const fs::path& file) {
  std::vector<Include> includes;
  for (const std::string& line : lines_of(file)) {
    if (line.rfind("#include", 0) != 0) continue;
    const auto begin = line.find_first_of("\"<"), end = line.find_last_of("\">");
    if (begin == std::string::npos || end <= begin) continue;
    includes.push_back({line.substr(begin + 1, end - begin - 1), line[begin] == '"'});
  }
  return includes;
}

std::string library_of(const std::string& include) { return include.substr(0, include.find('/')); }
std::string shown(const fs::path& file) { return fs::relative(file, kTop).string(); }

TEST(Architecture, TableNamesEveryLibraryInTheOrderOfTheBuild) {
  std::vector<std::string> table, built;
  for (const Row& row : stage_table()) table.push_back(row.library);
  for (const std::string& line : lines_of(kTop / "CMakeLists.txt")) {
    if (line.rfind("foreach(library ", 0) != 0) continue;
    built = words(line.substr(16, line.find(')') - 16));
  }
  EXPECT_EQ(table, built);
  std::set<std::string> folders;
  for (const auto& entry : fs::directory_iterator(kTop / "libs")) {
    if (entry.is_directory()) folders.insert(entry.path().filename());
  }
  EXPECT_EQ(folders, std::set<std::string>(table.begin(), table.end()));
}

TEST(Architecture, TableLooksDownOnly) {
  std::set<std::string> above;
  for (const Row& row : stage_table()) {
    for (const std::string& allowed : row.may_include) {
      EXPECT_TRUE(above.contains(allowed)) << row.library << " may not include " << allowed << ", which comes later";
    }
    above.insert(row.library);
  }
}

TEST(Architecture, TheTruthStaysOutside) {
  bool robot_side = false;
  for (const Row& row : stage_table()) {
    robot_side = robot_side || row.library == "localize";
    if (robot_side) {
      EXPECT_FALSE(row.may_include.contains("world") && row.library != "score") << row.library;
      EXPECT_FALSE(row.may_include.contains("sim")) << row.library;
    }
    if (row.library == "mission") robot_side = false;
  }
}

TEST(Architecture, LibrariesIncludeWhatTheirRowAllows) {
  std::set<std::string> libraries;
  for (const Row& row : stage_table()) libraries.insert(row.library);
  for (const Row& row : stage_table()) {
    for (const fs::path& file : sources_below(kTop / "libs" / row.library)) {
      for (const Include& include : includes_of(file)) {
        if (!include.quoted) continue;
        const std::string other = library_of(include.what);
        EXPECT_TRUE(libraries.contains(other)) << shown(file) << ": \"" << include.what << "\" is of no library";
        EXPECT_TRUE(other == row.library || row.may_include.contains(other)) << shown(file) << " includes " << other;
      }
    }
  }
}

/// One header of `motion` shows a type of its own internal/ as a member; nobody else's internal/ is ever included.
TEST(Architecture, InternalIsInternal) {
  for (const char* folder : {"libs", "apps"}) {
    for (const fs::path& file : sources_below(kTop / folder)) {
      for (const Include& include : includes_of(file)) {
        if (!include.quoted || include.what.find("/internal/") == std::string::npos) continue;
        EXPECT_EQ(shown(file).rfind("libs/" + library_of(include.what) + "/", 0), 0U)
            << shown(file) << " includes " << include.what;
      }
    }
  }
}

TEST(Architecture, ThirdPartyHeadersStayInside) {
  for (const fs::path& file : sources_below(kTop / "libs")) {
    if (file.extension() != ".hpp" || file.parent_path().filename() == "internal") continue;
    for (const Include& include : includes_of(file)) {
      if (include.quoted || include.what.rfind("Eigen/", 0) == 0) continue;
      EXPECT_EQ(include.what.find_first_of("./"), std::string::npos)
          << shown(file) << " shows <" << include.what << ">; the standard library and Eigen are allowed";
    }
  }
}

TEST(Architecture, PublicHeadersOpenWithAComment) {
  for (const fs::path& file : sources_below(kTop / "libs")) {
    if (file.extension() != ".hpp") continue;
    const auto lines = lines_of(file);
    ASSERT_FALSE(lines.empty()) << shown(file);
    EXPECT_EQ(lines.front().rfind("// ", 0), 0U) << shown(file);
  }
}

TEST(Architecture, LibrariesHaveAReadme) {
  for (const Row& row : stage_table()) {
    EXPECT_TRUE(fs::is_regular_file(kTop / "libs" / row.library / "README.md")) << row.library;
  }
}

TEST(Architecture, FilesAreShort) {
  for (const char* folder : {"libs", "apps"}) {
    for (const fs::path& file : sources_below(kTop / folder)) {
      EXPECT_LE(std::ssize(lines_of(file)), kMostLines) << shown(file);
    }
  }
}

TEST(Architecture, LibrariesNeitherPrintNorRollDice) {
  for (const fs::path& file : sources_below(kTop / "libs")) {
    for (const std::string& line : lines_of(file)) {
      for (const char* word : {"std::cout", "std::cerr", " printf(", "std::random_device", "system_clock", " rand()"}) {
        EXPECT_EQ(line.find(word), std::string::npos) << shown(file) << ": " << line;
      }
    }
  }
}

/// What stands in internal/ is tested by the same name, or through its library.
TEST(Architecture, SourcesHaveATestInTheMirroredPlace) {
  std::set<std::string> excused;
  for (const Row& row : stage_table()) {
    for (const auto& entry : fs::directory_iterator(kTop / "libs" / row.library)) {
      if (entry.path().extension() != ".cpp") continue;
      const std::string noun = row.library + "/" + entry.path().stem().string();
      const auto other = kTestedBy.find(noun);
      const std::string test = other == kTestedBy.end() ? noun + "_test.cpp" : other->second;
      EXPECT_TRUE(fs::is_regular_file(kTop / "tests" / test)) << noun << ".cpp: tests/" << test << " is missing";
      if (other == kTestedBy.end()) continue;
      excused.insert(noun);
      EXPECT_FALSE(fs::exists(kTop / "tests" / (noun + "_test.cpp"))) << noun << " needs no exception any more";
    }
  }
  EXPECT_EQ(excused.size(), kTestedBy.size()) << "an exception for a source that is not there";
}

TEST(Architecture, EveryLibraryIsTested) {
  for (const Row& row : stage_table()) {
    EXPECT_TRUE(fs::is_directory(kTop / "tests" / row.library)) << row.library << " has no tests";
  }
}

}  // namespace
