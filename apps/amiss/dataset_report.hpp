// report.html of a data set: its visits as they were recorded, and a picture from each.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace amiss::app {

/// `recordings`: folders with recording.json and rgb.txt. InputError for one that cannot be read.
[[nodiscard]] std::string dataset_page(const std::string& summary, const std::string& parameters,
                                       const std::vector<std::filesystem::path>& recordings);

}  // namespace amiss::app
