// Nested lists of words: what PDDL is written in.
//
// In: text; out: one list with line numbers, words in lower case. Errors: InputError "file:line: ..." on unbalanced
// brackets, bytes that no PDDL word has, text after the end and lists deeper than kMaxNesting, so that whoever walks
// the lists may recurse.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace amiss::plan {

inline constexpr std::size_t kMaxNesting = 200;
inline constexpr std::size_t kMaxFileBytes = std::size_t{64} << 20;

struct Sexpr {
  int line = 0;
  bool is_list = false;
  std::string word;          // when it is a word
  std::vector<Sexpr> items;  // when it is a list

  [[nodiscard]] bool is_word(std::string_view text) const { return !is_list && word == text; }
  /// The word that a list begins with; "" where it begins with none.
  [[nodiscard]] std::string_view head() const;
};

/// Where a text comes from; makes the sentence of an error.
struct Source {
  std::string name;
  [[noreturn]] void fail(int line, const std::string& what) const;
  [[noreturn]] void fail(const Sexpr& at, const std::string& what) const { fail(at.line, what); }
  /// The word, or an error saying that `what` was expected.
  [[nodiscard]] const std::string& word(const Sexpr& at, const std::string& what) const;
};

[[nodiscard]] Sexpr parse_sexpr(std::string_view text, const Source& source, int first_line = 1);

/// Short form of an expression for sentences: "(and (at ?x ...) ...)" becomes "(and ...)".
[[nodiscard]] std::string describe(const Sexpr& expression);

}  // namespace amiss::plan
