// What an experiment is: its file (YAML) -> Spec. Unknown keys, wrong types and values out of range are ArgumentErrors
// that name file and line; an unreadable file is an InputError.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace amiss::experiment {

/// A figure drawn from the merged results.
struct FigureSpec {
  enum class Shows { kSegmentations, kTime, kFound };
  std::string name;  // of its files
  std::string title, world;
  Shows shows = Shows::kSegmentations;
  std::vector<std::string> times;  // with which segmentation times (report/search_times.hpp)
};

/// All combinations of worlds, methods, numbers of objects and seeds are run.
struct Spec {
  std::string name;
  std::vector<std::string> worlds, methods;
  std::vector<int> objects;
  int runs = 10;  // seeds first_seed .. first_seed + runs - 1
  std::uint64_t first_seed = 1;
  /// The objects of a batch (a world and a number of objects) lie where the scatter seed plus their number says: the
  /// same for both methods and all runs.
  std::uint64_t scatter_seed = 1;
  double time_limit_s = 3600.0;                             // simulated, of a trial
  double trial_wall_s = 30.0;                               // what a trial takes on one core, before any was measured
  std::vector<std::pair<std::string, std::string>> params;  // deviations from the defaults
  std::vector<FigureSpec> figures;
};

[[nodiscard]] Spec load_spec(const std::filesystem::path& file);

}  // namespace amiss::experiment
