#include "completion.hpp"

#include <functional>

namespace amiss::app {

namespace {

/// In single quotes of a shell.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

using Visit = std::function<void(const Command& command, const std::string& path)>;

void for_each_command(const Command& command, const std::string& path, const Visit& visit) {
  visit(command, path);
  for (const Command& sub : command.subcommands) for_each_command(sub, path + " " + sub.name, visit);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// How a shell offers what an option or argument takes.
struct Offers {
  std::function<std::string(const std::vector<std::string>& words)> choices;
  std::string files, folders, worlds, parameters, nothing;

  [[nodiscard]] std::string of(const CommandOption& option) const {
    if (!option.choices.empty()) return choices(option.choices);
    if (option.value == "FILE") return files;
    if (option.value == "DIR") return folders;
    if (option.value == "WORLD") return worlds;
    if (option.value == "KEY=VALUE") return parameters;
    return nothing;
  }
};

/// The arms of a shell's `case "$at $previous"`: what follows an option.
std::string value_arms(const Command& program, const Offers& offers) {
  std::string arms;
  for_each_command(program, program.name, [&](const Command& command, const std::string& path) {
    for (const CommandOption& option : command.options) {
      if (option.value.empty()) continue;
      std::string patterns;
      for (const std::string& name : option.names) {
        patterns += (patterns.empty() ? "" : "|") + quoted(path + " " + name);
      }
      arms += "    " + patterns + ") " + offers.of(option) + "; return ;;\n";
    }
  });
  return arms;
}

/// The arms of `case "$at"`: what stands where no option was begun.
std::string argument_arms(const Command& program, const Offers& offers) {
  std::string arms;
  for_each_command(program, program.name, [&](const Command& command, const std::string& path) {
    if (command.positionals.empty()) return;
    arms += "    " + quoted(path) + ") " + offers.of(command.positionals.front()) + " ;;\n";
  });
  return arms;
}

/// All ways through the subcommands, as a pattern of `case`.
std::string path_pattern(const Command& program) {
  std::string pattern;
  for_each_command(program, program.name, [&](const Command& command, const std::string& path) {
    for (const Command& sub : command.subcommands) {
      pattern += (pattern.empty() ? "" : "|") + quoted(path + " " + sub.name);
    }
  });
  return pattern;
}

}  // namespace

std::string bash_completion(const Command& program) {
  const Offers offers{[](const std::vector<std::string>& words) { return "_amiss_words " + quoted(joined(words)); },
                      "_amiss_paths -f",
                      "_amiss_paths -d",
                      "_amiss_words \"$(\"${COMP_WORDS[0]}\" completion worlds 2>/dev/null)\"",
                      "_amiss_keys",
                      "COMPREPLY=()"};
  std::string word_arms;
  for_each_command(program, program.name, [&](const Command& command, const std::string& path) {
    std::vector<std::string> subcommands, options;
    for (const Command& sub : command.subcommands) subcommands.push_back(sub.name);
    for (const CommandOption& option : command.options)
      options.insert(options.end(), option.names.begin(), option.names.end());
    word_arms += "    " + quoted(path) + ") subcommands=" + quoted(joined(subcommands)) +
                 " options=" + quoted(joined(options)) + " ;;\n";
  });
  return "# bash completion of amiss; made by `amiss completion bash`\n"
         "_amiss_words() { mapfile -t COMPREPLY < <(compgen -W \"$1\" -- \"$current\"); }\n"
         "_amiss_paths() { compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen \"$1\" -- \"$current\"); "
         "}\n"
         "_amiss_keys() {\n"
         "  compopt -o nospace 2>/dev/null\n"
         "  mapfile -t COMPREPLY < <(compgen -S = -W \"$(\"${COMP_WORDS[0]}\" completion parameters 2>/dev/null)\" -- "
         "\"$current\")\n"
         "}\n"
         "_amiss() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} at=" +
         program.name +
         " i subcommands= options=\n"
         "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
         "    case \"$at ${COMP_WORDS[i]}\" in\n    " +
         path_pattern(program) +
         ") at+=\" ${COMP_WORDS[i]}\" ;;\n    esac\n  done\n"
         "  case \"$at $previous\" in\n" +
         value_arms(program, offers) + "  esac\n  case \"$at\" in\n" + word_arms +
         "  esac\n"
         "  if [[ $current == -* ]]; then _amiss_words \"$options\"; return; fi\n"
         "  if [[ -n $subcommands ]]; then _amiss_words \"$subcommands\"; return; fi\n"
         "  case \"$at\" in\n" +
         argument_arms(program, offers) + "    *) _amiss_words \"$options\" ;;\n  esac\n}\ncomplete -F _amiss " +
         program.name + "\n";
}

std::string zsh_completion(const Command& program) {
  const Offers offers{[](const std::vector<std::string>& words) { return "compadd -- " + joined(words); },
                      "_files",
                      "_files -/",
                      "compadd -- ${(f)\"$(\"${words[1]}\" completion worlds 2>/dev/null)\"}",
                      "compadd -S = -- ${(f)\"$(\"${words[1]}\" completion parameters 2>/dev/null)\"}",
                      "_message value"};
  const auto described = [](const std::string& name, std::string help) {
    std::string escaped;
    for (const char c : name) escaped += c == ':' ? std::string("\\:") : std::string(1, c);
    return quoted(escaped + ":" + help);
  };
  std::string word_arms;
  for_each_command(program, program.name, [&](const Command& command, const std::string& path) {
    std::string subcommands, options;
    for (const Command& sub : command.subcommands) subcommands += " " + described(sub.name, sub.help);
    for (const CommandOption& option : command.options) {
      for (const std::string& name : option.names) options += " " + described(name, option.help);
    }
    word_arms += "    " + quoted(path) + ") subcommands=(" + subcommands + " ) options=(" + options + " ) ;;\n";
  });
  return "#compdef " + program.name +
         "\n# zsh completion of amiss; made by `amiss completion zsh`\n"
         "_amiss() {\n"
         "  local at=" +
         program.name +
         " i\n  local -a subcommands options\n"
         "  for ((i = 2; i < CURRENT; i++)); do\n"
         "    case \"$at ${words[i]}\" in\n    " +
         path_pattern(program) +
         ") at+=\" ${words[i]}\" ;;\n    esac\n  done\n"
         "  case \"$at ${words[CURRENT-1]}\" in\n" +
         value_arms(program, offers) + "  esac\n  case \"$at\" in\n" + word_arms +
         "  esac\n"
         "  if [[ ${words[CURRENT]} == -* ]]; then _describe -o option options; return; fi\n"
         "  if (( ${#subcommands} )); then _describe command subcommands; return; fi\n"
         "  case \"$at\" in\n" +
         argument_arms(program, offers) + "    *) _describe -o option options ;;\n  esac\n}\n_amiss \"$@\"\n";
}

}  // namespace amiss::app
