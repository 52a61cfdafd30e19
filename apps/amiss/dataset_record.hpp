// Records one visit: the simulated robot drives its waypoints, and all that its sensors say is written.
// Into the folder: what libs/dataset/README.md says of a recording.
// False when the visit was interrupted or ran out of time.
#pragma once

#include "dataset_rooms.hpp"
#include "reference_cache.hpp"

namespace amiss::app {

struct VisitToRecord {
  const DatasetRoom& room;
  const DatasetSettings& settings;
  const PreparedReference& prepared;
  const sim::Visit& content;
  std::string scene;
  std::uint64_t seed = 1;
  bool rawlog = true;
};

[[nodiscard]] bool record_visit(const VisitToRecord& visit, const std::filesystem::path& folder);

}  // namespace amiss::app
