// A data set for change detection, made in simulation: everything that `amiss dataset make` does.
// DIR/dataset.yaml says what it is made of; DIR/placements/<room>/scene<N>/ what stands and lies where;
// DIR/recordings/<room>/scene<N>/ what the robot recorded (libs/dataset/README.md). Each folder is there whole or not at
// all, and what is there is not made again: a run that was stopped goes on where it was, and may ask for more rooms.
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
  std::string params_file;
  std::vector<std::string> overrides;
  bool rawlog = true;  // each recording also as an MRPT rawlog
  bool quiet = false;
  std::string child;  // this job alone, in this process (dataset_jobs.hpp)
};

/// The exit status.
[[nodiscard]] int make_dataset(const DatasetOptions& options);

}  // namespace amiss::app
