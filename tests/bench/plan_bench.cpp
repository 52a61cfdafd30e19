// Prints length and time of the planner on every problem of a reference file: plan_bench FOLDER/reference.json [PART OF
// A DOMAIN'S NAME]
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "plan/planner.hpp"
#include "plan/validator.hpp"

namespace {

using amiss::plan::Domain;
using amiss::plan::Problem;

void print_row(const std::filesystem::path& folder, const nlohmann::json& entry) {
  const auto begin = std::chrono::steady_clock::now();
  const Domain domain = amiss::plan::load_domain(folder / entry.at("domain").get<std::string>());
  const Problem problem = amiss::plan::load_problem(folder / entry.at("problem").get<std::string>(), domain);
  const auto answer = amiss::plan::solve(domain, problem);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const auto& counts = answer ? answer->counts : answer.why().counts;
  const bool is_unsolvable = !answer && answer.why().reason == amiss::plan::NoPlan::Reason::kUnsolvable;
  const std::string length =
      answer ? std::to_string(answer->plan.steps.size()) : std::string(is_unsolvable ? "none" : "limit");
  const bool is_valid = answer && validate(domain, problem, answer->plan);
  std::printf("%-26s %-26s %7s %7s %6s %6zu %6zu %7zu %5s %6s %8.3f\n", folder.filename().c_str(),
              entry.at("problem").get<std::string>().c_str(), entry.at("optimal_length").dump().c_str(),
              entry.at("ff_length").dump().c_str(), length.c_str(), counts.first_length, counts.ground_actions,
              counts.evaluated_states, counts.hill_climbing_sufficed ? "climb" : "best",
              answer ? (is_valid ? "valid" : "WRONG") : "", seconds);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "usage: plan_bench FOLDER/reference.json [PART OF A DOMAIN'S NAME]\n");
    return 2;
  }
  try {
    const std::filesystem::path file = argv[1];
    std::printf("%-26s %-26s %7s %7s %6s %6s %6s %7s %5s %6s %8s\n", "domain", "problem", "optimal", "ff", "length",
                "first", "ops", "states", "by", "plan", "seconds");
    for (const auto& entry : nlohmann::json::parse(amiss::load_bytes(file))) {
      const std::string name = entry.at("domain_dir");
      if (argc == 3 && name.find(argv[2]) == std::string::npos) continue;
      const auto beside = file.parent_path() / name;
      print_row(std::filesystem::exists(beside) ? beside : file.parent_path() / "dev" / name, entry);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
  return 0;
}
