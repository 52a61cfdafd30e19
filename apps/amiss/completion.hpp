// Completion scripts of the shells, from the declared commands. Names of worlds and of parameters are asked of the
// program when they are needed, so that a script stays right when they change.
#pragma once

#include <string>

#include "command_tree.hpp"

namespace amiss::app {

[[nodiscard]] std::string bash_completion(const Command& program);
[[nodiscard]] std::string zsh_completion(const Command& program);

}  // namespace amiss::app
