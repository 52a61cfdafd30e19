#include "world/internal/sdf_console.hpp"

#include <console_bridge/console.h>

#include <cstdlib>
#include <mutex>
#include <optional>
#include <sdf/Console.hh>
#include <string>

namespace amiss::world {

void silence_sdf_console() {
  static std::once_flag once;
  std::call_once(once, [] {
    // The console opens a log file below HOME when it is made, and hangs where there is no HOME: give it one in which
    // nothing can be made, for that moment.
    const char* home = std::getenv("HOME");
    const std::optional<std::string> kept = home != nullptr ? std::optional<std::string>(home) : std::nullopt;
    setenv("HOME", "/dev/null", 1);
    console_bridge::noOutputHandler();  // what is no SDF is tried as URDF, whose parser talks too
    sdf::Console::Instance()->SetQuiet(true);
    if (kept) {
      setenv("HOME", kept->c_str(), 1);
    } else {
      unsetenv("HOME");
    }
  });
}

}  // namespace amiss::world
