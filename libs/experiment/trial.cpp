#include "experiment/trial.hpp"

#include <fmt/format.h>

#include <sstream>

#include "core/files.hpp"
#include "core/result.hpp"

namespace amiss::experiment {

namespace {

constexpr std::size_t kIdDigits = 20;
constexpr std::string_view kHeading = "id\tworld\tmethod\tobjects\tseed\tscatter_seed\tprogram\n";

}  // namespace

std::vector<Trial> trials_of(const Spec& spec, const std::map<std::string, std::string>& keys,
                             const std::string& program) {
  std::vector<Trial> trials;
  for (const std::string& world : spec.worlds) {
    for (const int objects : spec.objects) {
      for (const std::string& method : spec.methods) {
        for (int run = 0; run < spec.runs; ++run) {
          Trial trial{"",
                      world,
                      method,
                      objects,
                      spec.first_seed + static_cast<std::uint64_t>(run),
                      spec.scatter_seed + static_cast<std::uint64_t>(objects),
                      program};
          const std::string all = fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n", keys.at(world), world, method,
                                              objects, trial.seed, trial.scatter_seed, spec.time_limit_s, program);
          trial.id = sha256(all).substr(0, kIdDigits);
          trials.push_back(std::move(trial));
        }
      }
    }
  }
  return trials;
}

std::vector<std::string> arguments_of(const Trial& trial, const Spec& spec, const std::string& out) {
  std::vector<std::string> arguments{"tidy",
                                     "--world=" + trial.world,
                                     "--method=" + trial.method,
                                     fmt::format("--objects={}", trial.objects),
                                     fmt::format("--seed={}", trial.seed),
                                     fmt::format("--scatter-seed={}", trial.scatter_seed),
                                     fmt::format("--time-limit={}", spec.time_limit_s),
                                     "--until=found",
                                     "--threads=1",
                                     "--quiet",
                                     "--out=" + out};
  for (const auto& [key, value] : spec.params) arguments.push_back(fmt::format("--set={}={}", key, value));
  return arguments;
}

std::string to_tsv(const std::vector<Trial>& trials) {
  std::string text(kHeading);
  for (const Trial& t : trials) {
    text += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\n", t.id, t.world, t.method, t.objects, t.seed, t.scatter_seed,
                        t.program);
  }
  return text;
}

std::vector<Trial> parse_plan(std::string_view text, const std::string& file) {
  if (!text.starts_with(kHeading)) throw InputError(file + ":1: is no plan of an experiment");
  std::istringstream lines{std::string(text.substr(kHeading.size()))};
  std::vector<Trial> trials;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    Trial t;
    if (!std::getline(fields, t.id, '\t') || !std::getline(fields, t.world, '\t') ||
        !std::getline(fields, t.method, '\t') || !(fields >> t.objects >> t.seed >> t.scatter_seed >> t.program) ||
        t.id.size() != kIdDigits) {
      throw InputError(fmt::format("{}:{}: id, world, method, objects, seed, scatter_seed and program are needed", file,
                                   trials.size() + 2));
    }
    trials.push_back(std::move(t));
  }
  return trials;
}

}  // namespace amiss::experiment
