// SIGINT and SIGTERM end a run in good order; a second one ends the program at once.
#pragma once

namespace amiss::app {

void catch_interrupts();
[[nodiscard]] bool interrupted();

}  // namespace amiss::app
