// One run of one method: what it is made of, its id, and the plan of an experiment as a table.
// The id is a hash of world, method, objects, seeds, parameters, reference and program, so that a result can never be
// taken for another's, nor one of a changed program for one of this.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/spec.hpp"

namespace amiss::experiment {

struct Trial {
  std::string id;  // 20 hex digits
  std::string world, method;
  int objects = 0;
  std::uint64_t seed = 0, scatter_seed = 0;
  std::string program{};  // that does it: a hash of its executable
  bool operator==(const Trial&) const = default;
};

/// All trials, in the order world, objects, method, seed. `keys`: for each world a text of all that its trials depend
/// on beside the fields of Trial and the time limit (world, robot, catalogue, parameters, reference). `program`: the
/// hash of the executable, without white space.
[[nodiscard]] std::vector<Trial> trials_of(const Spec& spec, const std::map<std::string, std::string>& keys,
                                           const std::string& program);

/// The arguments of `amiss` for a trial, its run folder in `out`.
[[nodiscard]] std::vector<std::string> arguments_of(const Trial& trial, const Spec& spec, const std::string& out);

/// Tab-separated, one line a trial.
[[nodiscard]] std::string to_tsv(const std::vector<Trial>& trials);
/// InputError naming `file` and line when it is no plan.
[[nodiscard]] std::vector<Trial> parse_plan(std::string_view text, const std::string& file);

}  // namespace amiss::experiment
