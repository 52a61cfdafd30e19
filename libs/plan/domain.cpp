#include "plan/domain.hpp"

#include <algorithm>
#include <array>

#include "core/files.hpp"
#include "plan/internal/formula_reader.hpp"

namespace amiss::plan {
namespace {

constexpr std::array kRequirements = {":strips",
                                      ":typing",
                                      ":negative-preconditions",
                                      ":disjunctive-preconditions",
                                      ":equality",
                                      ":existential-preconditions",
                                      ":universal-preconditions",
                                      ":quantified-preconditions",
                                      ":conditional-effects",
                                      ":adl",
                                      ":action-costs"};

class DomainReader {
 public:
  explicit DomainReader(const Source& source) : source_(source) {}

  Domain read(const Sexpr& whole) {
    read_name(whole);
    for (const Sexpr& item : whole.items) {
      if (item.head() == ":requirements") check_requirements(item);
    }
    for (std::size_t i = 2; i < whole.items.size(); ++i) check_section(whole.items[i]);
    read_types();
    for_each(":constants",
             [&](const Sexpr& section) { read_objects(section, 1, vocabulary_, source_, domain_.constants); });
    for_each(":predicates", [&](const Sexpr& section) { read_predicates(section); });
    for_each(":functions", [&](const Sexpr& section) { read_functions(section); });
    for_each(":action", [&](const Sexpr& section) { read_action(section); });
    return std::move(domain_);
  }

 private:
  void read_name(const Sexpr& whole) {
    if (whole.head() != "define")
      source_.fail(whole, "expected (define (domain name) ...), not '" + describe(whole) + "'");
    if (whole.items.size() < 2 || whole.items[1].head() != "domain" || whole.items[1].items.size() != 2) {
      source_.fail(whole, "expected (domain name) after 'define'; is this a domain?");
    }
    domain_.name = source_.word(whole.items[1].items[1], "the name of the domain");
  }

  void check_section(const Sexpr& section) {
    const std::string_view head = section.head();
    const std::array allowed = {":requirements", ":types", ":constants", ":predicates", ":functions", ":action"};
    if (std::find(allowed.begin(), allowed.end(), head) == allowed.end()) {
      source_.fail(section, "'" + describe(section) + "' is not supported; a domain may have " + join(allowed));
    }
    sections_.push_back(&section);
  }

  template <class Names>
  static std::string join(const Names& names) {
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : ", ") + std::string(name);
    return text;
  }

  template <class Use>
  void for_each(std::string_view head, const Use& use) {
    for (const Sexpr* section : sections_) {
      if (section->head() == head) use(*section);
    }
  }

  void check_requirements(const Sexpr& section) {
    for (std::size_t i = 1; i < section.items.size(); ++i) {
      const std::string& name = source_.word(section.items[i], "a requirement");
      if (std::find(kRequirements.begin(), kRequirements.end(), name) == kRequirements.end()) {
        source_.fail(section.items[i], "the requirement '" + describe(section.items[i]) +
                                           "' is not supported; allowed are " + join(kRequirements));
      }
    }
  }

  void read_types() {
    add_type("object");
    for_each(":types", [&](const Sexpr& section) {
      for (const TypedName& entry : read_typed_list(section, 1, source_)) {
        const std::size_t type = add_type(entry.name->word);
        for (const Sexpr* parent : entry.types) {
          const std::size_t above = add_type(parent->word);
          if (above != type) domain_.types[type].parents.push_back(static_cast<int>(above));
        }
      }
    });
    for (std::size_t type = 0; type < domain_.types.size(); ++type) mark_ancestors(type);
    for (std::size_t type = 1; type < domain_.types.size(); ++type) check_no_circle(type);
  }

  std::size_t add_type(const std::string& name) {
    if (vocabulary_.types.add(name)) domain_.types.push_back({name, {}, {}});
    return static_cast<std::size_t>(*vocabulary_.types.find(name));
  }

  void mark_ancestors(std::size_t type) {
    std::vector<bool> is_a(domain_.types.size(), false);
    is_a[0] = true;
    std::vector<std::size_t> open = {type};
    while (!open.empty()) {
      const std::size_t next = open.back();
      open.pop_back();
      if (is_a[next] && next != 0) continue;
      is_a[next] = true;
      for (const int parent : domain_.types[next].parents) {
        if (!is_a[static_cast<std::size_t>(parent)]) open.push_back(static_cast<std::size_t>(parent));
      }
    }
    domain_.types[type].is_a = std::move(is_a);
  }

  void check_no_circle(std::size_t type) {
    for (const int parent : domain_.types[type].parents) {
      if (parent != 0 && domain_.types[static_cast<std::size_t>(parent)].is_a[type]) {
        const Sexpr* section = nullptr;
        for_each(":types", [&](const Sexpr& one) { section = &one; });
        source_.fail(*section, "the type '" + domain_.types[type].name.substr(0, 60) + "' is its own ancestor");
      }
    }
  }

  void read_signature(const Sexpr& item, NameTable& names, std::vector<Signature>& signatures) {
    if (!item.is_list || item.items.empty()) source_.fail(item, "expected (name ?argument ...)");
    const std::string& name = source_.word(item.items[0], "a name");
    if (!names.add(name)) source_.fail(item, "'" + describe(item.items[0]) + "' is declared twice");
    signatures.push_back({name, read_variables(item, 1, vocabulary_, source_)});
  }

  void read_predicates(const Sexpr& section) {
    for (std::size_t i = 1; i < section.items.size(); ++i) {
      read_signature(section.items[i], vocabulary_.predicates, domain_.predicates);
    }
  }

  void read_functions(const Sexpr& section) {
    for (std::size_t i = 1; i < section.items.size(); ++i) {
      const Sexpr& item = section.items[i];
      if (item.is_word("-")) {
        if (i + 1 >= section.items.size() || !section.items[i + 1].is_word("number")) {
          source_.fail(item, "the value of a function must be of type 'number'");
        }
        ++i;
      } else if (item.head() == "total-cost" && item.items.size() == 1) {
        domain_.has_total_cost = true;
      } else {
        read_signature(item, vocabulary_.functions, domain_.functions);
      }
    }
  }

  void read_action(const Sexpr& section) {
    if (section.items.size() < 2) source_.fail(section, "expected (:action name :parameters (...) ...)");
    Action action;
    action.name = source_.word(section.items[1], "the name of the action");
    if (!actions_.add(action.name))
      source_.fail(section, "the action '" + describe(section.items[1]) + "' is declared twice");
    const Sexpr* const parameters = part(section, ":parameters");
    if (parameters != nullptr) action.parameters = read_variables(*parameters, 0, vocabulary_, source_);
    FormulaReader reader(domain_, vocabulary_, source_);
    reader.push(action.parameters, section);
    if (const Sexpr* const condition = part(section, ":precondition")) action.precondition = reader.formula(*condition);
    if (const Sexpr* const effect = part(section, ":effect")) reader.effects(*effect, action);
    action.variable_count = reader.most_variables();
    domain_.actions.push_back(std::move(action));
  }

  /// What follows a keyword of an action, nullptr where the action has none; checks all keywords on the way.
  const Sexpr* part(const Sexpr& action, std::string_view keyword) {
    const Sexpr* found = nullptr;
    for (std::size_t i = 2; i < action.items.size(); i += 2) {
      const Sexpr& key = action.items[i];
      if (!key.is_word(":parameters") && !key.is_word(":precondition") && !key.is_word(":effect")) {
        source_.fail(
            key, "'" + describe(key) + "' is no part of an action; allowed are :parameters, :precondition, :effect");
      }
      if (i + 1 >= action.items.size() || !action.items[i + 1].is_list) {
        source_.fail(key, "expected a list in brackets after '" + describe(key) + "'");
      }
      if (!key.is_word(keyword)) continue;
      if (found != nullptr) source_.fail(key, "'" + describe(key) + "' comes twice in one action");
      found = &action.items[i + 1];
    }
    return found;
  }

  const Source& source_;
  Domain domain_;
  Vocabulary vocabulary_;
  NameTable actions_{"action"};
  std::vector<const Sexpr*> sections_;
};

}  // namespace

bool accepts(const Domain& domain, const Variable& variable, int type) {
  const std::vector<bool>& is_a = domain.types[static_cast<std::size_t>(type)].is_a;
  return std::any_of(variable.types.begin(), variable.types.end(),
                     [&](int wanted) { return is_a[static_cast<std::size_t>(wanted)]; });
}

Domain parse_domain(std::string_view text, const std::string& name) {
  const Source source{name};
  return DomainReader(source).read(parse_sexpr(text, source));
}

Domain load_domain(const std::filesystem::path& file) {
  return parse_domain(load_bytes(file, kMaxFileBytes), file.string());
}

}  // namespace amiss::plan
