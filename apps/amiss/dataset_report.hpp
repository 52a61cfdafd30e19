// report.html of a data set: its visits as they were recorded, figures of them, and a picture from each.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace amiss::app {

/// Writes report.html and figures/ into `folder`. `recordings`: folders with recording.json, rgb/ and truth/.
/// InputError for one that cannot be read.
void save_dataset_report(const std::filesystem::path& folder, const std::string& summary, const std::string& parameters,
                         const std::vector<std::filesystem::path>& recordings);

}  // namespace amiss::app
