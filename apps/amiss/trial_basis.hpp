// What the trials of an experiment in one world depend on beside their own fields, and its reference made beforehand.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "experiment/spec.hpp"

namespace amiss::app {

/// For each world of the spec a text of hashes: world, robot, objects, planning domain, parameters, reference.
/// `--set` of a parameter that is not there is an ArgumentError, as in `amiss tidy`.
[[nodiscard]] std::map<std::string, std::string> trial_keys(const experiment::Spec& spec);

/// Makes the references that are not in the cache yet; `announce` is told the world first. False when stopped.
bool prepare_references(const experiment::Spec& spec, const std::function<void(const std::string&)>& announce);

}  // namespace amiss::app
