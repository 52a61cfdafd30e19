// Writes a PDDL problem from lists, so that a mission can put on disk what it knows and have it solved.
//
// In: names as they shall stand in the file (letters, digits, '-' and '_', a letter first). Out: PDDL text that
// parse_problem reads. Errors: ArgumentError naming the name that PDDL does not allow. Thesis 4.2.3.
#pragma once

#include <string>
#include <vector>

namespace amiss::plan {

struct ProblemText {
  struct Object {
    std::string name, type;
  };
  struct Fact {
    std::string predicate;
    std::vector<std::string> arguments;
  };
  struct Value {
    std::string function;
    std::vector<std::string> arguments;
    double value = 0;
  };
  std::string name, domain;
  std::vector<Object> objects;
  std::vector<Fact> init;
  std::vector<Value> values;
  std::vector<Fact> goal;  // all of them
  bool minimize_cost = false;
};

[[nodiscard]] std::string to_pddl(const ProblemText& problem);

}  // namespace amiss::plan
