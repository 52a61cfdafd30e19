#include "experiment/slurm.hpp"

#include <fmt/format.h>

#include <charconv>
#include <sstream>

namespace amiss::experiment {

namespace {

constexpr int kNoSuchProgram = 127;
constexpr std::string_view kQueueForm = "%j|%F|%K|%t|%r";  // name, array, task, state, reason

int number_of(std::string_view text, const std::string& where) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 0) {
    throw SlurmError(fmt::format("{}: '{}' is no number", where, text));
  }
  return number;
}

std::vector<std::string> with_names(std::vector<std::string> words, const std::vector<std::string>& names) {
  words.push_back(fmt::format("--name={}", fmt::join(names, ",")));
  return words;
}

}  // namespace

std::string Slurm::output_of(const std::vector<std::string>& words) const {
  const Ended ended = call_(words);
  if (ended.status == kNoSuchProgram) {
    throw SlurmError(words.front() +
                     ": there is no such program; --engine slurm needs Slurm's commands on the PATH (Debian's "
                     "slurm-client), on a machine from which its cluster takes jobs");
  }
  if (ended.signal != 0 || ended.status != 0) {
    // Slurm says the same several times, the reason last.
    const std::string said = last_line(ended.err);
    throw SlurmError(said.starts_with(words.front() + ":") ? said : fmt::format("{}: {}", words.front(), said));
  }
  return ended.out;
}

int Slurm::max_array_size() const { return parse_max_array_size(output_of({"scontrol", "show", "config"})); }

void Slurm::submit(const std::filesystem::path& script) const {
  (void)output_of({"sbatch", "--parsable", script.string()});
}

std::vector<QueuedTask> Slurm::queue(const std::vector<std::string>& names) const {
  if (names.empty()) return {};
  return parse_queue(
      output_of(with_names({"squeue", "--noheader", "--array", fmt::format("--format={}", kQueueForm)}, names)));
}

void Slurm::cancel(const std::vector<std::string>& names) const {
  for (const std::string& name : names) (void)output_of({"scancel", "--name=" + name});
}

void Slurm::cancel_task(const QueuedTask& task) const {
  (void)output_of({"scancel", fmt::format("{}_{}", task.id, task.task)});
}

int parse_max_array_size(std::string_view config) {
  std::istringstream lines{std::string(config)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key, equals, value;
    if (words >> key >> equals >> value && key == "MaxArraySize" && equals == "=") {
      return number_of(value, "scontrol: MaxArraySize");
    }
  }
  throw SlurmError("scontrol: its configuration tells no MaxArraySize");
}

std::vector<QueuedTask> parse_queue(std::string_view table) {
  std::istringstream lines{std::string(table)};
  std::vector<QueuedTask> tasks;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    QueuedTask task;
    std::string number, state;
    if (!std::getline(fields, task.job, '|') || !std::getline(fields, task.id, '|') ||
        !std::getline(fields, number, '|') || !std::getline(fields, state, '|')) {
      throw SlurmError(fmt::format("squeue: '{}' is no line of {}", line, kQueueForm));
    }
    std::getline(fields, task.reason);
    task.task = number_of(number, "squeue");
    task.runs = state != "PD";
    task.given_up = !task.runs && task.reason.find("requeued") != std::string::npos &&
                    task.reason.find("held") != std::string::npos;
    tasks.push_back(std::move(task));
  }
  return tasks;
}

}  // namespace amiss::experiment
