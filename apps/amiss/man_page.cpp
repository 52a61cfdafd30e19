#include "man_page.hpp"

#include "commands.hpp"

namespace amiss::app {

namespace {

/// roff reads backslashes, dashes, and a point or quote that begins a line.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if (c == '\'')
      result += "\\(aq";
    else if (c == '`')
      result += "\\(ga";
    else
      result += c;
  }
  if (!result.empty() && result.front() == '.') result.insert(0, "\\&");
  return result;
}

std::string bold(const std::string& text) { return "\\fB" + plain(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + plain(text) + "\\fR"; }

std::string value_of(const CommandOption& option) {
  if (option.choices.empty()) return italic(option.value);
  std::string text;
  for (const std::string& choice : option.choices) text += (text.empty() ? "" : "|") + bold(choice);
  return text;
}

std::string paragraph(const CommandOption& option, bool positional) {
  std::string head;
  for (const std::string& name : option.names)
    head += (head.empty() ? "" : ", ") + (positional ? italic(name) : bold(name));
  if (!positional && !option.value.empty()) head += " " + value_of(option);
  std::string text = ".TP\n" + head + "\n" + plain(option.help);
  if (!option.limits.empty()) text += " (" + plain(option.limits) + ")";
  if (!option.default_text.empty()) text += " [" + plain(option.default_text) + "]";
  return text + "\n";
}

std::string usage(const Command& command, const std::string& path) {
  std::string line = bold(path);
  if (!command.options.empty()) line += " [" + italic("options") + "]";
  for (const CommandOption& p : command.positionals) line += " " + italic(p.names.front());
  if (!command.subcommands.empty()) line += " " + italic("command");
  return line;
}

void append_commands(const Command& command, const std::string& path, std::string& page) {
  for (const Command& sub : command.subcommands) {
    const std::string name = path + " " + sub.name;
    page += ".SS " + usage(sub, name) + "\n" + plain(sub.help) + "\n";
    for (const CommandOption& p : sub.positionals) page += paragraph(p, true);
    for (const CommandOption& o : sub.options) page += paragraph(o, false);
    append_commands(sub, name, page);
  }
}

std::string parameter_rows(const ParamTable& parameters) {
  std::string rows;
  for (const ParamTable::Row& row : parameters.rows()) {
    rows += ".TP\n" + bold(row.key) + " = " + plain(row.print()) + "\n" + plain(row.meaning) + " (" +
            plain(row.allowed) + ")\n";
  }
  return rows;
}

}  // namespace

std::string man_page(const Command& program, const ParamTable& parameters, const std::string& version) {
  std::string page = ".TH AMISS 1 \"\" \"amiss " + plain(version) + "\" \"User Commands\"\n.SH NAME\n" +
                     plain(program.name) + " \\- " + plain(program.help) + "\n.SH SYNOPSIS\n" +
                     usage(program, program.name) + "\n.SH OPTIONS\n";
  for (const CommandOption& option : program.options) page += paragraph(option, false);
  page += ".SH COMMANDS\n";
  append_commands(program, program.name, page);
  page += ".SH EXIT STATUS\n";
  for (const ExitStatus& status : kExitStatuses) {
    page += ".TP\n" + bold(std::to_string(status.value)) + "\n" + plain(status.meaning) + "\n";
  }
  page +=
      ".SH ENVIRONMENT\n.TP\n.B AMISS_SHARE\nwhere worlds, objects and the robot are, if not beside the program\n"
      ".TP\n.B XDG_CACHE_HOME\nreferences of worlds are kept in its folder amiss [~/.cache]\n.SH PARAMETERS\n"
      "Of a file for \\fB\\-\\-params\\fR, or \\fB\\-\\-set\\fR \\fIkey\\fR=\\fIvalue\\fR:\n" +
      parameter_rows(parameters);
  return page;
}

}  // namespace amiss::app
