// One recording, from its folder to the folder of its reconstruction.
#pragma once

#include <functional>
#include <string>

#include "dataset/recording.hpp"
#include "mapping/reconstructor.hpp"
#include "report/run_folder.hpp"

namespace amiss::app {

struct ReconstructJob {
  const dataset::Recording& recording;
  std::string name;  // of the recording, for the report
  mapping::ReconstructionParams params;
  std::size_t every = 1;  // only the first of so many frames
  bool threaded = false;  // the next frame is read beside the work on this one; the files are the same
  std::function<bool()> stop = [] { return false; };
  std::function<void(const std::string& line)> progress = [](const std::string&) {};
};

/// Writes cloud.ply, cloud.pcd, mesh.ply (where the method has triangles), space.bt, trajectory.txt and report.json.
/// Returns what to tell people; empty when it was stopped.
std::string reconstruct(const ReconstructJob& job, const report::RunFolder& folder);

}  // namespace amiss::app
