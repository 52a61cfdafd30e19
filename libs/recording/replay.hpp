// Perception of a recorded run, without the simulator and without a mission: localize -> insert into the map ->
// difference with the reference -> regions -> segments (thesis, figure 4.2 without plan and motion). Compares and
// segments where the recorded mission did, so that a whole recording gives the regions and objects of its run. Where
// the source tells no decisions it compares every search.compare seconds and at the end, and segments a region when a
// frame shows the whole of it from at most exam.max_dist.
//
// in: Source, reference, parameters     out: regions and objects in the knowledge base, the voxel map; map frame
// InputError where decisions of the recording do not fit what is perceived.
#pragma once

#include "knowledge/knowledge_base.hpp"
#include "mission/params.hpp"
#include "mission/reference.hpp"
#include "recording/source.hpp"

namespace amiss::recording {

struct ReplayReport {
  mapping::VoxelMap voxels;
  PoseEstimate pose;  // the last
  int periods = 0, frames = 0, comparisons = 0, segmentations = 0;
  bool complete = false;  // the recording had its own end
};

[[nodiscard]] ReplayReport replay(Source& recording, const mission::Reference& reference, const mission::Params& params,
                                  knowledge::KnowledgeBase& knowledge, const mission::Sinks& sinks);

}  // namespace amiss::recording
