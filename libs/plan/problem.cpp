#include "plan/problem.hpp"

#include <algorithm>

#include "core/files.hpp"
#include "plan/internal/formula_reader.hpp"

namespace amiss::plan {
namespace {

class ProblemReader {
 public:
  ProblemReader(const Domain& domain, const Source& source)
      : domain_(domain), source_(source), vocabulary_(vocabulary_of(domain)) {
    problem_.objects = domain.constants;
  }

  Problem read(const Sexpr& whole) {
    read_name(whole);
    for (std::size_t i = 2; i < whole.items.size(); ++i) sort_section(whole.items[i]);
    if (objects_ != nullptr) read_objects(*objects_, 1, vocabulary_, source_, problem_.objects);
    if (init_ != nullptr) read_init();
    if (goal_ == nullptr) source_.fail(whole, "the problem has no (:goal ...)");
    read_goal();
    if (metric_ != nullptr) read_metric();
    return std::move(problem_);
  }

 private:
  void read_name(const Sexpr& whole) {
    if (whole.head() != "define")
      source_.fail(whole, "expected (define (problem name) ...), not '" + describe(whole) + "'");
    if (whole.items.size() < 2 || whole.items[1].head() != "problem" || whole.items[1].items.size() != 2) {
      source_.fail(whole, "expected (problem name) after 'define'; is this a problem?");
    }
    problem_.name = source_.word(whole.items[1].items[1], "the name of the problem");
  }

  void sort_section(const Sexpr& section) {
    const std::string_view head = section.head();
    if (head == ":domain") {
      check_domain(section);
    } else if (head == ":objects") {
      keep(section, objects_);
    } else if (head == ":init") {
      keep(section, init_);
    } else if (head == ":goal") {
      keep(section, goal_);
    } else if (head == ":metric") {
      keep(section, metric_);
    } else if (head != ":requirements") {
      source_.fail(section, "'" + describe(section) +
                                "' is not supported; a problem may have :domain, :requirements, " +
                                ":objects, :init, :goal, :metric");
    }
  }

  void keep(const Sexpr& section, const Sexpr*& place) {
    if (place != nullptr) source_.fail(section, "'" + describe(section) + "' comes twice");
    place = &section;
  }

  void check_domain(const Sexpr& section) {
    if (section.items.size() != 2) source_.fail(section, "expected (:domain name)");
    if (source_.word(section.items[1], "the name of the domain") != domain_.name) {
      source_.fail(section, "the problem is for the domain '" + describe(section.items[1]) +
                                "', the domain given is '" + domain_.name.substr(0, 60) + "'");
    }
  }

  void read_init() {
    for (std::size_t i = 1; i < init_->items.size(); ++i) {
      const Sexpr& item = init_->items[i];
      if (item.head() == "=") {
        read_value(item);
      } else if (item.head() == "at" && !vocabulary_.predicates.find("at")) {
        source_.fail(item, "timed literals are not supported; everything in :init holds at the beginning");
      } else if (item.head() != "not") {
        problem_.init.push_back(ground_atom(item, vocabulary_.predicates, domain_.predicates));
      } else if (item.items.size() == 2) {  // what is not listed is false anyway
        (void)ground_atom(item.items[1], vocabulary_.predicates, domain_.predicates);
      } else {
        source_.fail(item, "'" + describe(item) + "' should be (not (predicate object ...))");
      }
    }
    sort_init();
  }

  void sort_init() {
    std::sort(problem_.init.begin(), problem_.init.end());
    problem_.init.erase(std::unique(problem_.init.begin(), problem_.init.end()), problem_.init.end());
    auto& values = problem_.values;
    std::stable_sort(values.begin(), values.end(),
                     [](const FunctionValue& a, const FunctionValue& b) { return a.term < b.term; });
    const auto twice =
        std::adjacent_find(values.begin(), values.end(), [](const auto& a, const auto& b) { return a.term == b.term; });
    if (twice != values.end()) {
      const std::string& name = domain_.functions[static_cast<std::size_t>(twice->term.symbol)].name;
      source_.fail(*init_, "a value of the function '" + name.substr(0, 60) + "' is given twice");
    }
  }

  void read_value(const Sexpr& item) {
    if (item.items.size() != 3 || !item.items[1].is_list) {
      source_.fail(item, "'" + describe(item) + "' should be (= (function object ...) number)");
    }
    const double value = read_cost(item.items[2], source_);
    if (item.items[1].head() == "total-cost" && item.items[1].items.size() == 1 && domain_.has_total_cost) {
      if (value > 0) source_.fail(item, "(total-cost) must be 0 at the beginning");
      return;
    }
    problem_.values.push_back({ground_atom(item.items[1], vocabulary_.functions, domain_.functions), value});
  }

  GroundAtom ground_atom(const Sexpr& item, const NameTable& names, const std::vector<Signature>& signatures) {
    if (!item.is_list || item.items.empty()) {
      source_.fail(item, "expected (name object ...), not '" + describe(item) + "'");
    }
    GroundAtom atom{names.at(item.items[0], source_), {}};
    const std::size_t wanted = signatures[static_cast<std::size_t>(atom.symbol)].parameters.size();
    if (item.items.size() != wanted + 1) {
      source_.fail(item, "'" + describe(item) + "' has " + std::to_string(item.items.size() - 1) +
                             " arguments; the domain declares " + std::to_string(wanted));
    }
    for (std::size_t i = 1; i < item.items.size(); ++i) {
      atom.objects.push_back(vocabulary_.objects.at(item.items[i], source_));
    }
    return atom;
  }

  void read_goal() {
    if (goal_->items.size() != 2) source_.fail(*goal_, "expected (:goal condition)");
    FormulaReader reader(domain_, vocabulary_, source_);
    problem_.goal = reader.formula(goal_->items[1]);
    problem_.goal_variable_count = reader.most_variables();
  }

  void read_metric() {
    const auto& items = metric_->items;
    if (items.size() != 3 || !items[1].is_word("minimize") || items[2].head() != "total-cost" ||
        items[2].items.size() != 1 || !domain_.has_total_cost) {
      source_.fail(*metric_,
                   "only (:metric minimize (total-cost)) is supported, with (total-cost) declared in :functions");
    }
    problem_.minimize_cost = true;
  }

  const Domain& domain_;
  const Source& source_;
  Vocabulary vocabulary_;
  Problem problem_;
  const Sexpr* objects_ = nullptr;
  const Sexpr* init_ = nullptr;
  const Sexpr* goal_ = nullptr;
  const Sexpr* metric_ = nullptr;
};

}  // namespace

Problem parse_problem(std::string_view text, const Domain& domain, const std::string& name) {
  const Source source{name};
  return ProblemReader(domain, source).read(parse_sexpr(text, source));
}

Problem load_problem(const std::filesystem::path& file, const Domain& domain) {
  return parse_problem(load_bytes(file, kMaxFileBytes), domain, file.string());
}

std::string to_string(const Domain& domain, const Problem& problem, const GroundAtom& atom) {
  std::string text = "(" + domain.predicates[static_cast<std::size_t>(atom.symbol)].name;
  for (const int object : atom.objects) text += " " + problem.objects[static_cast<std::size_t>(object)].name;
  return text + ")";
}

}  // namespace amiss::plan
