// amiss(1), from the declared commands, the table of parameters and the exit statuses.
#pragma once

#include <string>

#include "command_tree.hpp"
#include "core/params.hpp"

namespace amiss::app {

[[nodiscard]] std::string man_page(const Command& program, const ParamTable& parameters, const std::string& version);

}  // namespace amiss::app
