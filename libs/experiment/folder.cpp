#include "experiment/folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <set>

#include "core/files.hpp"
#include "core/result.hpp"

namespace amiss::experiment {

namespace fs = std::filesystem;

namespace {

fs::path spec_of(const fs::path& path) { return path / "experiment.yaml"; }
fs::path plan_of(const fs::path& path) { return path / "plan.tsv"; }

/// A world may be named by its file.
fs::path basis_of(const fs::path& path, const std::string& world) {
  return path / "basis" / (fs::path(world).stem().string() + "-" + sha256(world).substr(0, 8) + ".txt");
}

/// Why these trials are not those of the folder.
std::string why_other(const fs::path& path, const std::vector<Trial>& trials) {
  const auto before = parse_plan(load_bytes(plan_of(path)), plan_of(path).string());
  if (!before.empty() && !trials.empty() && before.front().program != trials.front().program) {
    return fmt::format(
        "holds results of another program ({}; this one is {}), for amiss changed since then, and results of two "
        "programs are not mixed; a new folder is allowed for --out",
        before.front().program, trials.front().program);
  }
  return "holds another experiment, or its world, parameters or robot changed since then; a new folder is allowed for "
         "--out";
}

}  // namespace

Folder::Folder(fs::path path, Spec spec, std::vector<Trial> trials)
    : path_(std::move(path)), spec_(std::move(spec)), trials_(std::move(trials)) {
  for (const char* name : {"trials", "times", "work"}) fs::create_directories(path_ / name);
}

Folder Folder::begin(const fs::path& path, const fs::path& spec_file, const std::vector<Trial>& trials) {
  Spec spec = load_spec(spec_file);
  const std::string plan = to_tsv(trials);
  std::error_code error;
  fs::create_directories(path, error);
  if (error || !fs::is_directory(path)) throw ArgumentError(path.string() + ": cannot be made a folder");
  if (fs::exists(plan_of(path))) {
    if (load_bytes(plan_of(path)) != plan) throw ArgumentError(path.string() + ": " + why_other(path, trials));
  } else if (!fs::is_empty(path) && !fs::exists(spec_of(path))) {
    throw ArgumentError(path.string() +
                        ": holds something else; a folder that is new, empty or of this experiment is "
                        "allowed for --out");
  }
  save_atomically(spec_of(path), load_bytes(spec_file));
  save_atomically(plan_of(path), plan);
  return {fs::absolute(path), std::move(spec), trials};
}

Folder Folder::open(const fs::path& path) {
  if (!fs::exists(plan_of(path)))
    throw InputError(path.string() + ": is no folder of an experiment (plan.tsv is missing)");
  auto trials = parse_plan(load_bytes(plan_of(path)), plan_of(path).string());
  return {fs::absolute(path), load_spec(spec_of(path)), std::move(trials)};
}

std::string Folder::spec_text() const { return load_bytes(spec_of(path_)); }

const Trial& Folder::trial(const std::string& id) const {
  const auto found = std::find_if(trials_.begin(), trials_.end(), [&](const Trial& t) { return t.id == id; });
  if (found == trials_.end()) throw ArgumentError(id + ": is no trial of " + path_.string());
  return *found;
}

fs::path Folder::result_file(const Trial& trial) const { return path_ / "trials" / (trial.id + ".json"); }

bool Folder::has(const Trial& trial) const { return fs::exists(result_file(trial)); }

/// One look at the folder: far cheaper on a file system of a network than one for each trial.
std::vector<Trial> Folder::missing() const {
  std::set<std::string> there;
  for (const auto& entry : fs::directory_iterator(path_ / "trials")) there.insert(entry.path().filename().string());
  std::vector<Trial> missing;
  std::copy_if(trials_.begin(), trials_.end(), std::back_inserter(missing),
               [&](const Trial& t) { return !there.contains(result_file(t).filename().string()); });
  return missing;
}

std::string Folder::result_bytes(const Trial& trial) const { return load_bytes(result_file(trial)); }

TrialResult Folder::result(const Trial& trial) const {
  return parse_result(trial, result_bytes(trial), result_file(trial).string());
}

std::vector<TrialResult> Folder::results() const {
  std::vector<TrialResult> results;
  for (const Trial& trial : trials_) {
    if (has(trial)) results.push_back(result(trial));
  }
  return results;
}

std::optional<TrialTimes> Folder::times(const Trial& trial) const {
  const fs::path file = path_ / "times" / (trial.id + ".json");
  if (!fs::exists(file)) return std::nullopt;
  return parse_times(load_bytes(file), file.string());
}

/// The times first: who sees a result may ask for them.
void Folder::save_result(const Trial& trial, std::string_view text, std::string_view times) const {
  if (!times.empty()) save_atomically(path_ / "times" / (trial.id + ".json"), times);
  save_atomically(result_file(trial), text);
}

void Folder::forget_failures() const {
  for (const TrialResult& result : results()) {
    if (result.failed) fs::remove(result_file(result.trial));
  }
}

std::optional<FileLock> Folder::claim(const Trial& trial) const {
  return FileLock::take(path_ / "work" / (trial.id + ".claim"));
}

fs::path Folder::work_folder(const Trial& trial) const {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  fs::path folder = path_ / "work" / fmt::format("{}.{}.{}", trial.id, host.data(), ::getpid());
  fs::remove_all(folder);
  return folder;
}

void Folder::clear_work() const {
  const fs::path cleared = path_ / "work" / "cleared";
  std::error_code gone;
  fs::remove_all(cleared, gone);
  for (const auto& entry : fs::directory_iterator(path_ / "work")) {
    fs::rename(entry, cleared, gone);
    fs::remove_all(cleared, gone);
  }
  for (const char* name : {"trials", "times"}) {  // what was half written when a run was killed
    for (const auto& entry : fs::directory_iterator(path_ / name)) {
      if (entry.path().extension() != ".json") fs::remove(entry, gone);
    }
  }
}

void Folder::require_program(const std::string& program) const {
  if (!trials_.empty() && trials_.front().program != program) {
    throw ArgumentError(fmt::format("{}: is for another program ({}; this one is {}); results of two are not mixed",
                                    path_.string(), trials_.front().program, program));
  }
}

void Folder::save_basis(const std::map<std::string, std::string>& keys) const {
  for (const auto& [world, key] : keys) save(basis_of(path_, world), key);
}

std::map<std::string, std::string> Folder::basis() const {
  std::map<std::string, std::string> keys;
  for (const std::string& world : spec_.worlds) keys[world] = load_bytes(basis_of(path_, world));
  return keys;
}

void Folder::save(const fs::path& name, std::string_view bytes) const {
  fs::create_directories((path_ / name).parent_path());
  save_atomically(path_ / name, bytes);
}

}  // namespace amiss::experiment
