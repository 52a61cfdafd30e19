// Valid inputs of a fuzz target, from which mutations are made.
#pragma once

#include <string>
#include <vector>

namespace amiss::fuzz {

[[nodiscard]] std::vector<std::string> valid_inputs();

/// Words that matter in the format of the target.
[[nodiscard]] std::vector<std::string> words();

}  // namespace amiss::fuzz
