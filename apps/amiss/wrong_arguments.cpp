#include "wrong_arguments.hpp"

#include <algorithm>

#include "core/params.hpp"

namespace amiss::app {

namespace {

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string meant(const std::string& word, const std::vector<std::string>& known, const std::string& otherwise) {
  const std::string near = nearest_word(word, known);
  return near.empty() ? otherwise : "; did you mean '" + near + "'?";
}

std::vector<std::string> names_of(const std::vector<Command>& commands) {
  std::vector<std::string> names;
  for (const Command& command : commands) names.push_back(command.name);
  return names;
}

const CommandOption* option_named(const Command& command, const std::string& name) {
  for (const CommandOption& option : command.options) {
    if (std::find(option.names.begin(), option.names.end(), name) != option.names.end()) return &option;
  }
  return nullptr;
}

/// One word after the other, down the commands.
class Reader {
 public:
  Reader(const Command& program, const std::vector<std::string>& words)
      : here_(&program), path_(program.name), words_(words) {}

  /// The first word that is neither an option nor a command here; nothing where there is none.
  std::string unknown() {
    for (const std::string& word : words_) {
      const std::string sentence = word.starts_with("--") ? unknown_option(word.substr(0, word.find('='))) : step(word);
      if (!sentence.empty()) return sentence;
    }
    if (here_->subcommands.empty()) return {};
    return path_ + " needs one of its subcommands: " + listed(names_of(here_->subcommands));
  }

  /// The first value that is not one of the few that its option takes.
  std::string wrong_choice() {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (!words_[i].starts_with("-")) {
        (void)step(words_[i]);
        continue;
      }
      const std::size_t equals = words_[i].find('=');
      const CommandOption* option = option_named(*here_, words_[i].substr(0, equals));
      if (option == nullptr || option->choices.empty()) continue;
      if (equals == std::string::npos && i + 1 == words_.size()) continue;
      const std::string value = equals == std::string::npos ? words_[i + 1] : words_[i].substr(equals + 1);
      const std::vector<std::string>& allowed = option->choices;
      if (std::find(allowed.begin(), allowed.end(), value) != allowed.end()) continue;
      return option->names.back() + " " + value + " is not allowed" + meant(value, allowed, ".") +
             " Allowed: " + listed(allowed);
    }
    return {};
  }

 private:
  std::string unknown_option(const std::string& word) const {
    std::vector<std::string> known{"--help"};
    for (const CommandOption& option : here_->options)
      known.insert(known.end(), option.names.begin(), option.names.end());
    if (std::find(known.begin(), known.end(), word) != known.end()) return {};
    return "`" + path_ + "` has no option " + word + meant(word, known, "; `" + path_ + " --help` lists them");
  }

  std::string step(const std::string& word) {
    if (here_->subcommands.empty()) return {};
    const auto found = std::find_if(here_->subcommands.begin(), here_->subcommands.end(),
                                    [&](const Command& sub) { return sub.name == word; });
    if (found == here_->subcommands.end()) {
      const std::vector<std::string> names = names_of(here_->subcommands);
      return path_ + " has no subcommand '" + word + "'" + meant(word, names, "; there are: " + listed(names));
    }
    here_ = &*found;
    path_ += " " + word;
    return {};
  }

  const Command* here_;
  std::string path_;
  const std::vector<std::string>& words_;
};

}  // namespace

std::string explain(const Command& program, const std::vector<std::string>& words, const Refusal& refusal) {
  Reader reader(program, words);
  std::string better;
  if (refusal.kind == Refusal::Kind::kWord) better = reader.unknown();
  if (refusal.kind == Refusal::Kind::kValue) better = reader.wrong_choice();
  return better.empty() ? refusal.sentence : better;
}

}  // namespace amiss::app
