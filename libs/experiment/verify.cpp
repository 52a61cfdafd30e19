#include "experiment/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "core/files.hpp"
#include "core/result.hpp"
#include "experiment/merge.hpp"

namespace amiss::experiment {

namespace fs = std::filesystem;

namespace {

std::string name_of(const Trial& t) {
  return fmt::format("{} ({}, {}, {} objects, seed {})", t.id, t.world, t.method, t.objects, t.seed);
}

void check_plan(const Folder& folder, std::vector<std::string>& wrong) {
  const std::vector<Trial>& trials = folder.trials();
  std::set<std::string> ids, programs;
  for (const Trial& t : trials) {
    if (!ids.insert(t.id).second) wrong.push_back("plan.tsv: " + t.id + " stands in it twice");
    programs.insert(t.program);
  }
  if (programs.size() > 1) {
    wrong.push_back(fmt::format("plan.tsv: trials of {} programs ({})", programs.size(), fmt::join(programs, ", ")));
    return;
  }
  try {
    const std::string program = programs.empty() ? "" : *programs.begin();
    if (trials_of(folder.spec(), folder.basis(), program) != trials) {
      wrong.push_back("plan.tsv: does not follow from experiment.yaml and basis/");
    }
  } catch (const InputError& e) {
    wrong.emplace_back(e.what());
  }
}

/// A file that no planned trial is looked for in.
std::string stray(const Folder& folder, const fs::path& file) {
  const auto json = nlohmann::json::parse(load_bytes(file), nullptr, false);
  const std::string id = json.is_object() && json.contains("id") ? json["id"].dump() : "";
  for (const Trial& t : folder.trials()) {
    if (id == "\"" + t.id + "\"") return file.string() + ": is another result of " + name_of(t);
  }
  return file.string() + ": belongs to no planned trial";
}

void check_strays(const Folder& folder, std::vector<std::string>& wrong) {
  std::set<fs::path> expected, found;
  for (const Trial& t : folder.trials()) expected.insert(folder.result_file(t));
  for (const auto& entry : fs::directory_iterator(folder.path() / "trials")) found.insert(entry.path());
  for (const fs::path& file : found) {
    if (!expected.contains(file)) wrong.push_back(stray(folder, file));
  }
}

void check_merged(const Folder& folder, std::vector<std::string>& wrong) {
  for (const auto& [name, bytes] : merged_files(folder)) {
    if (fs::exists(folder.path() / name) && load_bytes(folder.path() / name) != bytes) {
      wrong.push_back(name + ": is not what merging gives now; `amiss experiment merge` makes it again");
    }
  }
}

}  // namespace

Verified verify(const fs::path& path) {
  const Folder folder = Folder::open(path);
  Verified verified;
  verified.planned = folder.trials().size();
  check_plan(folder, verified.wrong);
  check_strays(folder, verified.wrong);
  bool readable = true;
  for (const Trial& trial : folder.trials()) {
    if (!folder.has(trial)) {
      verified.wrong.push_back(name_of(trial) + ": has no result");
      continue;
    }
    try {
      verified.failed += folder.result(trial).failed ? 1U : 0U;
      ++verified.results;
    } catch (const InputError& e) {
      verified.wrong.emplace_back(e.what());
      readable = false;
    }
  }
  if (readable) check_merged(folder, verified.wrong);
  return verified;
}

}  // namespace amiss::experiment
