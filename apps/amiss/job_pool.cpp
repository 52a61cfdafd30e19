#include "job_pool.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <map>
#include <stdexcept>
#include <thread>

#include "commands.hpp"
#include "core/result.hpp"
#include "interrupt.hpp"

namespace amiss::app {

namespace {

constexpr auto kPoll = std::chrono::milliseconds(50);

int guarded(const Job& job) {
  try {
    return job.run();
  } catch (const ArgumentError& error) {
    std::cerr << "amiss: " << job.name << ": " << error.what() << "\n";
    return kWrongArguments;
  } catch (const std::exception& error) {
    std::cerr << "amiss: " << job.name << ": " << error.what() << "\n";
    return kUnreadableInput;
  }
}

pid_t begin(const Job& job) {
  std::cout.flush();
  std::cerr.flush();
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process could be started for " + job.name);
  if (child == 0) {
    const int status = guarded(job);
    std::cout.flush();
    std::fflush(nullptr);
    ::_exit(status);
  }
  return child;
}

int status_of(int how) { return WIFEXITED(how) ? WEXITSTATUS(how) : 128 + WTERMSIG(how); }

}  // namespace

std::vector<JobResult> run_jobs(const std::vector<Job>& jobs, int at_a_time,
                                const std::function<void(const JobResult&)>& done) {
  std::map<pid_t, std::size_t> running;
  std::map<std::size_t, JobResult> ended;
  std::size_t next = 0;
  bool told = false;
  while (true) {
    while (!interrupted() && next < jobs.size() && running.size() < static_cast<std::size_t>(at_a_time)) {
      running[begin(jobs[next])] = next;
      ++next;
    }
    if (interrupted() && !told) {
      for (const auto& [child, job] : running) ::kill(child, SIGTERM);
      told = true;
    }
    if (running.empty()) break;
    int how = 0;
    const pid_t child = ::waitpid(-1, &how, WNOHANG);  // not for ever: an interrupt has to be passed on
    const auto found = running.find(child);
    if (found == running.end()) {
      std::this_thread::sleep_for(kPoll);
      continue;
    }
    const JobResult result{jobs[found->second].name, status_of(how)};
    ended[found->second] = result;
    running.erase(found);
    done(result);
  }
  std::vector<JobResult> results;
  for (auto& [index, result] : ended) results.push_back(std::move(result));
  return results;
}

}  // namespace amiss::app
