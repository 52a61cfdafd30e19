// What is wrong with a command line that was refused: the declared commands, the words after the program's name and
// the parser's own sentence -> one sentence that names the word and what is meant or allowed.
#pragma once

#include <string>
#include <vector>

#include "command_tree.hpp"

namespace amiss::app {

/// What the parser found, and its sentence, which stays where there is no better one.
struct Refusal {
  enum class Kind { kWord, kValue, kOther };  // a word that is unknown or missing; a value that is not allowed
  Kind kind;
  std::string sentence;
};

[[nodiscard]] std::string explain(const Command& program, const std::vector<std::string>& words,
                                  const Refusal& refusal);

}  // namespace amiss::app
