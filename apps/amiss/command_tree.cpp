#include "command_tree.hpp"

#include <CLI/CLI.hpp>

namespace amiss::app {

namespace {

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

/// CLI11 joins the type and what its checks say: "TEXT:{dynamic,static}", "INT:INT in [0 - 100]".
void set_value(CommandOption& option, const std::string& type) {
  const std::size_t colon = type.find(':');
  option.value = type.substr(0, colon);
  if (colon == std::string::npos) return;
  const std::string check = type.substr(colon + 1);
  if (check.size() > 2 && check.front() == '{' && check.back() == '}') {
    option.choices = split(check.substr(1, check.size() - 2));
  } else {
    option.limits = check;
  }
}

CommandOption option_of(const CLI::Option& declared) {
  CommandOption option;
  for (const std::string& name : declared.get_snames()) option.names.push_back("-" + name);
  for (const std::string& name : declared.get_lnames()) option.names.push_back("--" + name);
  if (option.names.empty()) option.names.push_back(declared.get_name(true));
  option.help = declared.get_description();
  option.default_text = declared.get_default_str();
  option.required = declared.get_required();
  if (declared.get_expected_max() > 0) set_value(option, declared.get_type_name());
  return option;
}

}  // namespace

Command command_tree(const CLI::App& app) {
  Command command;
  command.name = app.get_name();
  command.help = app.get_description();
  for (const CLI::Option* declared : app.get_options()) {
    const bool hidden = declared->get_group().empty();
    if (hidden) continue;
    (declared->get_positional() ? command.positionals : command.options).push_back(option_of(*declared));
  }
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App* s) { return !s->get_group().empty(); })) {
    command.subcommands.push_back(command_tree(*sub));
  }
  return command;
}

}  // namespace amiss::app
