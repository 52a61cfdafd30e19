// libsdformat talks on its own: to stderr and to a log file in the home folder.
#pragma once

namespace amiss::world {

/// Makes it quiet, once for the process; its errors come back as values anyway.
void silence_sdf_console();

}  // namespace amiss::world
