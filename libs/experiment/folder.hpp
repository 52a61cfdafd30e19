// The folder of an experiment: experiment.yaml (the spec as it was), plan.tsv, trials/ID.json, times/ID.json, work/ for
// what is under way, basis/WORLD.txt (what the ids stand for), and what merging makes of it. A result file is there
// whole or not at all, so that a run may be killed at any time; the same trial done twice writes the same bytes.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiment/file_lock.hpp"
#include "experiment/result.hpp"
#include "experiment/spec.hpp"
#include "experiment/trial.hpp"

namespace amiss::experiment {

class Folder {
 public:
  /// Makes it, or takes up the same experiment again. ArgumentError when it holds something else or another experiment.
  static Folder begin(const std::filesystem::path& path, const std::filesystem::path& spec_file,
                      const std::vector<Trial>& trials);
  /// One that is there already; InputError when it is none.
  static Folder open(const std::filesystem::path& path);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const Spec& spec() const { return spec_; }
  [[nodiscard]] std::string spec_text() const;  // as it was written
  [[nodiscard]] const std::vector<Trial>& trials() const { return trials_; }
  [[nodiscard]] const Trial& trial(const std::string& id) const;  // ArgumentError when there is none

  [[nodiscard]] std::filesystem::path result_file(const Trial& trial) const;
  [[nodiscard]] bool has(const Trial& trial) const;
  [[nodiscard]] std::vector<Trial> missing() const;
  [[nodiscard]] std::string result_bytes(const Trial& trial) const;
  [[nodiscard]] TrialResult result(const Trial& trial) const;
  [[nodiscard]] std::vector<TrialResult> results() const;  // of the trials that are there, in the order of the plan
  [[nodiscard]] std::optional<TrialTimes> times(const Trial& trial) const;

  void save_result(const Trial& trial, std::string_view text, std::string_view times) const;
  void forget_failures() const;  // so that they are run again
  /// Held while a trial is done; nothing when another process does it.
  [[nodiscard]] std::optional<FileLock> claim(const Trial& trial) const;
  /// A new folder for one run of a trial, which nobody else uses.
  [[nodiscard]] std::filesystem::path work_folder(const Trial& trial) const;
  /// What runs that were killed left. What another process is at loses its folder as a whole and is begun again.
  void clear_work() const;
  /// ArgumentError when the plan was made for another program than this one.
  void require_program(const std::string& program) const;
  /// What the ids of the trials were made from, beside the spec: a text for each world (trials_of).
  void save_basis(const std::map<std::string, std::string>& keys) const;
  [[nodiscard]] std::map<std::string, std::string> basis() const;
  void save(const std::filesystem::path& name, std::string_view bytes) const;

 private:
  Folder(std::filesystem::path path, Spec spec, std::vector<Trial> trials);

  std::filesystem::path path_;
  Spec spec_;
  std::vector<Trial> trials_;
};

}  // namespace amiss::experiment
