#include "plan/internal/sexpr.hpp"

#include "core/result.hpp"

namespace amiss::plan {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v'; }
bool is_word_char(char c) { return c > ' ' && c < 127 && c != '(' && c != ')' && c != ';'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

class SexprParser {
 public:
  SexprParser(std::string_view text, const Source& source, int first_line)
      : text_(text), source_(source), line_(first_line) {}

  Sexpr parse() {
    skip_space();
    if (at_end()) source_.fail(line_, "the file is empty; expected (define ...)");
    if (text_[next_] != '(') source_.fail(line_, "expected '(' at the beginning of (define ...)");
    std::vector<Sexpr> open;
    while (true) {
      skip_space();
      if (at_end()) source_.fail(open.back().line, "the list '" + describe(open.back()) + "' is not closed by ')'");
      if (text_[next_] == '(') {
        begin_list(open);
      } else if (text_[next_] == ')') {
        ++next_;
        Sexpr done = std::move(open.back());
        open.pop_back();
        if (open.empty()) return finish(std::move(done));
        open.back().items.push_back(std::move(done));
      } else {
        open.back().items.push_back(read_word());
      }
    }
  }

 private:
  [[nodiscard]] bool at_end() const { return next_ >= text_.size(); }

  void skip_space() {
    for (; !at_end(); ++next_) {
      if (text_[next_] == ';') {
        while (!at_end() && text_[next_] != '\n') ++next_;
        if (at_end()) return;
      }
      if (text_[next_] == '\n') ++line_;
      if (!is_space(text_[next_])) return;
    }
  }

  void begin_list(std::vector<Sexpr>& open) {
    if (open.size() >= kMaxNesting) {
      source_.fail(line_,
                   "lists are nested deeper than " + std::to_string(kMaxNesting) + ", which is the most allowed");
    }
    ++next_;
    open.push_back({.line = line_, .is_list = true, .word = {}, .items = {}});
  }

  Sexpr read_word() {
    Sexpr result{.line = line_, .is_list = false, .word = {}, .items = {}};
    for (; !at_end() && is_word_char(text_[next_]); ++next_) {
      if (text_[next_] == '?' && !result.word.empty()) break;  // "(at?x)": a variable begins a word
      result.word += lower(text_[next_]);
    }
    if (result.word.empty()) {
      source_.fail(line_, "the byte " + std::to_string(static_cast<unsigned char>(text_[next_])) +
                              " stands outside of a comment; PDDL is written in printable ASCII");
    }
    return result;
  }

  Sexpr finish(Sexpr whole) {
    skip_space();
    if (!at_end()) source_.fail(line_, "text after the last ')'; one (define ...) is allowed in a file");
    return whole;
  }

  std::string_view text_;
  const Source& source_;
  std::size_t next_ = 0;
  int line_;
};

}  // namespace

std::string_view Sexpr::head() const {
  return is_list && !items.empty() && !items.front().is_list ? std::string_view(items.front().word)
                                                             : std::string_view();
}

void Source::fail(int line, const std::string& what) const {
  throw InputError(name + ":" + std::to_string(line) + ": " + what);
}

const std::string& Source::word(const Sexpr& at, const std::string& what) const {
  if (at.is_list) fail(at, "expected " + what + " instead of the list '" + describe(at) + "'");
  return at.word;
}

Sexpr parse_sexpr(std::string_view text, const Source& source, int first_line) {
  return SexprParser(text, source, first_line).parse();
}

std::string describe(const Sexpr& expression) {
  constexpr std::size_t kLongest = 60;
  if (!expression.is_list) {
    return expression.word.size() > kLongest ? expression.word.substr(0, kLongest) + "..." : expression.word;
  }
  std::string text = "(";
  for (const Sexpr& item : expression.items) {
    if (text.size() > 1) text += ' ';
    if (item.is_list || text.size() + item.word.size() > kLongest) return text + "...)";
    text += item.word;
  }
  return text + ")";
}

}  // namespace amiss::plan
