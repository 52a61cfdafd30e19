#include "experiment/array_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>

#include "core/result.hpp"
#include "experiment/process.hpp"

namespace amiss::experiment {

namespace {

constexpr std::string_view kBegin = "<<'TASKS'\n", kEnd = "TASKS\n";

void check_option(const std::string& option) {
  if (!option.starts_with('-') || option.find('\n') != std::string::npos) {
    throw ArgumentError(fmt::format("'{}' is no option of sbatch; one such as --partition=short is allowed", option));
  }
}

}  // namespace

std::vector<Task> tasks_of(const std::vector<Trial>& trials, int chunk) {
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (i % static_cast<std::size_t>(chunk) == 0) tasks.emplace_back();
    tasks.back().push_back(trials[i].id);
  }
  return tasks;
}

/// The options of the user come last, so that they win. Output goes to the log by the shell, since a path may hold
/// what sbatch would replace in a name of its own.
std::string to_text(const ArrayScript& script) {
  std::string text = fmt::format(
      "#!/bin/sh\n#SBATCH --job-name={}\n#SBATCH --array=0-{}{}\n#SBATCH --nodes=1\n#SBATCH --ntasks=1\n"
      "#SBATCH --cpus-per-task=1\n#SBATCH --mem=1G\n#SBATCH --requeue\n#SBATCH --output=/dev/null\n",
      script.name, script.tasks.size() - 1, script.at_a_time > 0 ? fmt::format("%{}", script.at_a_time) : "");
  for (const std::string& option : script.options) {
    check_option(option);
    text += "#SBATCH " + option + "\n";
  }
  text += fmt::format("mkdir -p {}\n", shell_quoted(script.log.parent_path().string()));
  text += fmt::format("exec >{}$SLURM_ARRAY_TASK_ID.log 2>&1\n", shell_quoted(script.log.string()));
  text += fmt::format("trials=$(sed -n \"$((SLURM_ARRAY_TASK_ID + 1))p\" {}", kBegin);
  for (const Task& task : script.tasks) text += fmt::format("{}\n", fmt::join(task, " "));
  text += fmt::format("{})\nexec {} experiment work {} $trials\n", kEnd, shell_quoted(script.program.string()),
                      shell_quoted(script.folder.string()));
  return text;
}

std::vector<Task> parse_tasks(std::string_view script, const std::string& file) {
  const auto begin = script.find(kBegin);
  const auto end = begin == std::string_view::npos ? begin : script.find(kEnd, begin + kBegin.size());
  if (end == std::string_view::npos) throw InputError(file + ": is no script of a job array of amiss");
  std::istringstream lines{std::string(script.substr(begin + kBegin.size(), end - begin - kBegin.size()))};
  std::vector<Task> tasks;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    tasks.emplace_back(std::istream_iterator<std::string>(words), std::istream_iterator<std::string>());
  }
  return tasks;
}

}  // namespace amiss::experiment
