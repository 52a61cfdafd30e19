// The declarations of the command line as plain values: what completion and the man page are made from.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace amiss::app {

/// An option, or an argument without a name of its own.
struct CommandOption {
  std::vector<std::string> names;  // with their dashes; of a positional one its name alone
  std::string help, default_text;
  std::string value;                 // WORLD, FILE, DIR, KEY=VALUE, TEXT, ...; empty for a flag
  std::string limits;                // "INT in [0 - 100]" as CLI11 says it; may be empty
  std::vector<std::string> choices;  // where only these are allowed
  bool required = false;
};

struct Command {
  std::string name, help;
  std::vector<CommandOption> options, positionals;
  std::vector<Command> subcommands;
};

/// All that is not hidden, in the order of its declaration.
[[nodiscard]] Command command_tree(const CLI::App& app);

}  // namespace amiss::app
