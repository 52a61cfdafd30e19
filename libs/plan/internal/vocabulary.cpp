#include "plan/internal/vocabulary.hpp"

#include <algorithm>

#include "core/params.hpp"

namespace amiss::plan {
namespace {

std::vector<const Sexpr*> read_type_names(const Sexpr& type, const Source& source) {
  if (!type.is_list) return {&type};
  if (type.head() != "either" || type.items.size() < 2) {
    source.fail(type, "'" + describe(type) + "' is no type; allowed are a name and (either name ...)");
  }
  std::vector<const Sexpr*> names;
  for (std::size_t i = 1; i < type.items.size(); ++i) {
    (void)source.word(type.items[i], "the name of a type");
    names.push_back(&type.items[i]);
  }
  return names;
}

}  // namespace

bool NameTable::add(const std::string& name) {
  const auto [where, is_new] = numbers_.emplace(name, static_cast<int>(names_.size()));
  if (is_new) names_.push_back(name);
  return is_new;
}

std::optional<int> NameTable::find(const std::string& name) const {
  const auto found = numbers_.find(name);
  if (found == numbers_.end()) return std::nullopt;
  return found->second;
}

int NameTable::at(const Sexpr& word, const Source& source) const {
  const std::string& name = source.word(word, "the name of a " + kind_);
  if (const std::optional<int> number = find(name)) return *number;
  const std::string near = names_.size() <= 1000 ? nearest_word(name, names_) : std::string();
  source.fail(word, "the " + kind_ + " '" + describe(word) + "' is not declared" +
                        (near.empty() ? std::string() : "; did you mean '" + near + "'?"));
}

Vocabulary vocabulary_of(const Domain& domain) {
  Vocabulary vocabulary;
  for (const Type& type : domain.types) vocabulary.types.add(type.name);
  for (const Object& constant : domain.constants) vocabulary.objects.add(constant.name);
  for (const Signature& predicate : domain.predicates) vocabulary.predicates.add(predicate.name);
  for (const Signature& function : domain.functions) vocabulary.functions.add(function.name);
  return vocabulary;
}

std::vector<TypedName> read_typed_list(const Sexpr& list, std::size_t first, const Source& source) {
  std::vector<TypedName> entries;
  std::size_t untyped = 0;  // entries before this one have their types
  for (std::size_t i = first; i < list.items.size(); ++i) {
    const Sexpr& item = list.items[i];
    if (!item.is_word("-")) {
      (void)source.word(item, "a name");
      entries.push_back({&item, {}});
      continue;
    }
    if (i + 1 >= list.items.size()) source.fail(item, "a type is missing after '-'");
    if (untyped == entries.size()) source.fail(item, "names are missing before '-'");
    const std::vector<const Sexpr*> types = read_type_names(list.items[++i], source);
    for (; untyped < entries.size(); ++untyped) entries[untyped].types = types;
  }
  return entries;
}

std::vector<Variable> read_variables(const Sexpr& list, std::size_t first, const Vocabulary& vocabulary,
                                     const Source& source) {
  std::vector<Variable> variables;
  for (const TypedName& entry : read_typed_list(list, first, source)) {
    const std::string& name = entry.name->word;
    if (name.size() < 2 || name[0] != '?') {
      source.fail(*entry.name, "'" + describe(*entry.name) + "' is no variable; variables begin with '?'");
    }
    const auto same_name = [&](const Variable& other) { return other.name == name; };
    if (std::any_of(variables.begin(), variables.end(), same_name)) {
      source.fail(*entry.name, "the variable '" + describe(*entry.name) + "' comes twice in one list");
    }
    Variable variable{name, {}};
    for (const Sexpr* type : entry.types) variable.types.push_back(vocabulary.types.at(*type, source));
    if (variable.types.empty()) variable.types.push_back(0);
    variables.push_back(std::move(variable));
  }
  return variables;
}

void read_objects(const Sexpr& list, std::size_t first, Vocabulary& vocabulary, const Source& source,
                  std::vector<Object>& objects) {
  for (const TypedName& entry : read_typed_list(list, first, source)) {
    const std::string& name = entry.name->word;
    if (name[0] == '?') source.fail(*entry.name, "the object '" + describe(*entry.name) + "' has a variable's name");
    if (entry.types.size() > 1) source.fail(*entry.name, "an object is of one type; (either ...) is for variables");
    const int type = entry.types.empty() ? 0 : vocabulary.types.at(*entry.types[0], source);
    if (vocabulary.objects.add(name)) {
      objects.push_back({name, type});
    } else if (objects[static_cast<std::size_t>(*vocabulary.objects.find(name))].type != type) {
      source.fail(*entry.name, "the object '" + describe(*entry.name) + "' is declared twice with different types");
    }
  }
}

}  // namespace amiss::plan
