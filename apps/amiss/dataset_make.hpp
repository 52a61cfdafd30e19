// A data set for change detection, made in simulation: everything that `amiss dataset make` does.
// DIR/dataset.yaml says what it is made of; DIR/placements/<room>/<scene>/ what stands and lies where;
// DIR/recordings/<room>/<scene>/ what the robot recorded. Each folder is there whole or not at all, what is there is not
// made again: a run that was stopped goes on where it was.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace amiss::app {

struct DatasetOptions {
  std::string out;
  std::vector<std::string> rooms;  // all where none is named
  std::optional<int> visits;       // of each room after the tidy one, at most
  std::uint64_t seed = 1;
  int jobs = 1;
  bool place_only = false;
  std::string params_file;
  std::vector<std::string> overrides;
  bool quiet = false;
};

/// The exit status.
[[nodiscard]] int make_dataset(const DatasetOptions& options);

}  // namespace amiss::app
