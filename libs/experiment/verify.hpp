// Whether the folder of an experiment is whole: folder -> what is wrong with it, a sentence each. Every planned trial
// has one result, every result belongs to a planned trial and is as it was written, the plan follows from the spec and
// from what the ids stand for, one program did all, and what was merged is what merging gives now. InputError for a
// folder that is no experiment's.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace amiss::experiment {

struct Verified {
  std::size_t planned = 0, results = 0, failed = 0;
  std::vector<std::string> wrong;
};
[[nodiscard]] Verified verify(const std::filesystem::path& folder);

}  // namespace amiss::experiment
