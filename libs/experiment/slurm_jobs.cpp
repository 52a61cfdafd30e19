#include "experiment/slurm_jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/files.hpp"

namespace amiss::experiment {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostTrialsInScript = 50'000;  // 1 MiB; sbatch takes 4

fs::path scripts_of(const Folder& folder) { return folder.path() / "slurm"; }
fs::path script_file(const Folder& folder, int number) { return scripts_of(folder) / fmt::format("{}.sh", number); }
fs::path log_of(const Folder& folder, int number) { return scripts_of(folder) / fmt::format("{}_", number); }

std::string job_name(const Folder& folder, int number) {
  constexpr std::size_t kDigits = 12;
  const std::string all = folder.path().string() + "\n" + to_tsv(folder.trials());
  return fmt::format("amiss-{}-{}", sha256(all).substr(0, kDigits), number);
}

}  // namespace

std::vector<std::string> slurm_scripts(const Folder& folder, const std::vector<Trial>& trials,
                                       const std::string& program, const SlurmOptions& options, int max_array_size,
                                       int first) {
  const std::vector<Task> tasks = tasks_of(trials, options.chunk);
  const std::size_t at_most = std::max<std::size_t>(1, kMostTrialsInScript / static_cast<std::size_t>(options.chunk));
  const std::size_t size = std::min(at_most, static_cast<std::size_t>(std::max(1, max_array_size)));
  std::vector<std::string> scripts;
  for (std::size_t begin = 0; begin < tasks.size(); begin += size, ++first) {
    const auto from = tasks.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto to = tasks.begin() + static_cast<std::ptrdiff_t>(std::min(tasks.size(), begin + size));
    scripts.push_back(to_text({job_name(folder, first),
                               program,
                               folder.path(),
                               log_of(folder, first),
                               options.at_a_time,
                               options.sbatch,
                               {from, to}}));
  }
  return scripts;
}

void remove_scripts(const Folder& folder) { fs::remove_all(scripts_of(folder)); }

SlurmJobs::SlurmJobs(const Folder& folder, std::string program, SlurmOptions options, Slurm::Call call)
    : folder_(folder),
      program_(std::move(program)),
      options_(std::move(options)),
      slurm_(std::move(call)),
      max_array_size_(slurm_.max_array_size()) {
  while (fs::exists(script_file(folder_, last_ + 1))) adopt(++last_);
}

void SlurmJobs::adopt(int number) {
  const fs::path file = script_file(folder_, number);
  tasks_[job_name(folder_, number)] = parse_tasks(load_bytes(file), file.string());
}

/// A script is there before its job, and stays when the job seems refused: one that Slurm took nevertheless, or just
/// before this program was killed, is found in the queue.
std::string SlurmJobs::submit(const std::vector<Trial>& trials) {
  bool any = false;
  for (const std::string& script : slurm_scripts(folder_, trials, program_, options_, max_array_size_, last_ + 1)) {
    const fs::path file = script_file(folder_, last_ + 1);
    folder_.save(fs::relative(file, folder_.path()), script);
    adopt(last_ + 1);
    try {
      slurm_.submit(file);
    } catch (const SlurmError& e) {
      if (!any) throw;
      return e.what();
    }
    any = true;
    ++last_;
  }
  return "";
}

std::vector<QueuedTask> SlurmJobs::queue() const {
  std::vector<QueuedTask> queue = slurm_.queue(names());
  for (const QueuedTask& task : queue) {
    if (task.given_up) slurm_.cancel_task(task);
  }
  std::erase_if(queue, [](const QueuedTask& task) { return task.given_up; });
  return queue;
}

std::vector<Trial> SlurmJobs::without(const std::vector<Trial>& trials, const std::vector<QueuedTask>& queue) const {
  std::set<std::string> queued;
  for (const QueuedTask& task : queue) {
    const std::vector<Task>& tasks = tasks_.at(task.job);
    const auto index = static_cast<std::size_t>(task.task);
    if (index < tasks.size()) queued.insert(tasks[index].begin(), tasks[index].end());
  }
  std::vector<Trial> others;
  std::copy_if(trials.begin(), trials.end(), std::back_inserter(others),
               [&](const Trial& t) { return !queued.contains(t.id); });
  return others;
}

std::string SlurmJobs::last_words(const Trial& trial) const {
  for (int number = last_; number > 0; --number) {
    const std::vector<Task>& tasks = tasks_.at(job_name(folder_, number));
    const auto task = std::find_if(tasks.begin(), tasks.end(), [&](const Task& ids) {
      return std::find(ids.begin(), ids.end(), trial.id) != ids.end();
    });
    if (task == tasks.end()) continue;
    const std::string log = fmt::format("{}{}.log", log_of(folder_, number).string(), task - tasks.begin());
    return fs::exists(log) ? last_line(load_bytes(log)) : "";
  }
  return "";
}

std::vector<std::string> SlurmJobs::names() const {
  std::vector<std::string> names;
  for (const auto& [name, tasks] : tasks_) names.push_back(name);
  return names;
}

void SlurmJobs::forget() const {
  if (!queue().empty()) slurm_.cancel(names());
  remove_scripts(folder_);
}

}  // namespace amiss::experiment
