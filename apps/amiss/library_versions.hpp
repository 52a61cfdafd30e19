// The main libraries that this process has loaded, with their versions: "Eigen 3.4.0, MRPT 2.5.8, ...".
#pragma once

#include <string>

namespace amiss::app {

[[nodiscard]] std::string library_versions();

}  // namespace amiss::app
