// Table 5.2 as a figure: the averages over the rooms, bars with standard deviations for each method.
#pragma once

#include <string>

#include "experiment/figure.hpp"
#include "experiment/table.hpp"

namespace amiss::app {

inline constexpr const char* kAverageRoom = "average";  // of score::table52

/// `table`: as save_tables makes it; of several reconstructions each has its bars.
[[nodiscard]] experiment::Figure averages_figure(const experiment::Table& table, const std::string& name);

}  // namespace amiss::app
