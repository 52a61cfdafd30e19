// Looking up the names of a domain and its objects, with a hint at the nearest known name where one is unknown.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "plan/domain.hpp"
#include "plan/internal/sexpr.hpp"

namespace amiss::plan {

/// Names of one kind, each once, numbered in the order of adding.
class NameTable {
 public:
  explicit NameTable(std::string kind) : kind_(std::move(kind)) {}

  /// False when the name was there before.
  bool add(const std::string& name);
  [[nodiscard]] std::optional<int> find(const std::string& name) const;
  /// The number of the name, or an InputError with the nearest known one.
  [[nodiscard]] int at(const Sexpr& word, const Source& source) const;

 private:
  std::string kind_;
  std::vector<std::string> names_;
  std::unordered_map<std::string, int> numbers_;
};

struct Vocabulary {
  NameTable types{"type"}, objects{"object"}, predicates{"predicate"}, functions{"function"};
};

/// All names of a domain; its constants are the first objects.
[[nodiscard]] Vocabulary vocabulary_of(const Domain& domain);

/// One entry of "a b - t c": a name with its types ({0}, object, where none are said).
struct TypedName {
  const Sexpr* name;
  std::vector<const Sexpr*> types;
};

/// Reads items[first..] as "name ... - type" or "name ... - (either type ...)" groups.
[[nodiscard]] std::vector<TypedName> read_typed_list(const Sexpr& list, std::size_t first, const Source& source);

/// The same as variables: names begin with '?', types are known, no name comes twice.
[[nodiscard]] std::vector<Variable> read_variables(const Sexpr& list, std::size_t first, const Vocabulary& vocabulary,
                                                   const Source& source);

/// The same as objects, appended to `objects` and to the vocabulary. A name may come again with the same type.
void read_objects(const Sexpr& list, std::size_t first, Vocabulary& vocabulary, const Source& source,
                  std::vector<Object>& objects);

}  // namespace amiss::plan
