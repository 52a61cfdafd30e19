#include "experiment/array_script.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "experiment/process.hpp"

namespace amiss::experiment {
namespace {

namespace fs = std::filesystem;

std::vector<Trial> trials_named(const std::vector<std::string>& ids) {
  std::vector<Trial> trials;
  for (const std::string& id : ids) trials.push_back({id, "lab_30", "static", 1, 1, 1});
  return trials;
}

TEST(ArrayScript, SeveralTrialsForEachTask) {
  EXPECT_EQ(tasks_of(trials_named({"a", "b", "c", "d", "e"}), 2), (std::vector<Task>{{"a", "b"}, {"c", "d"}, {"e"}}));
  EXPECT_EQ(tasks_of(trials_named({"a", "b"}), 9), (std::vector<Task>{{"a", "b"}}));
  EXPECT_TRUE(tasks_of({}, 2).empty());
}

TEST(ArrayScript, ATaskDoesItsTrials) {
  const test::TemporaryFolder folder;
  const fs::path place = folder.path() / "it's a %a place";
  fs::create_directories(place);
  const fs::path program = folder.write("it's a %a place/program", "#!/bin/sh\nprintf '<%s>' \"$@\"\n");
  fs::permissions(program, fs::perms::owner_all);
  const std::vector<Task> tasks{{"a", "b"}, {"c"}};
  const std::string text = to_text({"amiss-1", program, place, place / "log" / "1_", 3, {"--partition=short"}, tasks});
  EXPECT_EQ(parse_tasks(text, "1.sh"), tasks);
  EXPECT_NE(text.find("#SBATCH --array=0-1%3\n"), std::string::npos);
  EXPECT_NE(text.find("#SBATCH --job-name=amiss-1\n"), std::string::npos);
  EXPECT_GT(text.find("#SBATCH --partition=short\n"), text.find("#SBATCH --mem=")) << "users have the last word";
  for (const auto& [task, said] : std::vector<std::pair<std::string, std::string>>{{"0", "<a><b>"}, {"1", "<c>"}}) {
    const std::string call = "SLURM_ARRAY_TASK_ID=" + task + " exec sh";
    const Ended ended = run_program({"sh", "-c", call}, text, [] { return false; });
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(folder.read("it's a %a place/log/1_" + task + ".log"),
              "<experiment><work><" + place.string() + ">" + said);
  }
  EXPECT_NE(to_text({"amiss-1", program, place, place / "1_", 0, {}, tasks}).find("--array=0-1\n"), std::string::npos);
}

TEST(ArrayScript, RefusesWhatIsNone) {
  EXPECT_THROW((void)parse_tasks("#!/bin/sh\necho\n", "1.sh"), InputError);
  EXPECT_THROW((void)parse_tasks("<<'TASKS'\na b\n", "1.sh"), InputError) << "cut";
  for (const char* option : {"partition=short", "", "--time=1\nrm -r x"}) {
    EXPECT_THROW((void)to_text({"n", "p", "f", "l", 0, {option}, {{"a"}}}), ArgumentError) << option;
  }
}

}  // namespace
}  // namespace amiss::experiment
