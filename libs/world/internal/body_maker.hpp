// Trees -> rigid bodies: links that joints tie together are one body, a static model is one body.
#pragma once

#include <string>
#include <vector>

#include "world/internal/model_tree.hpp"

namespace amiss::world {

/// Bodies of a model at T_parent_model. A sentence is added to `warnings` for what a rigid body cannot do.
[[nodiscard]] std::vector<Body> make_bodies(const ModelTree& model, std::vector<std::string>& warnings);

/// "name", "name_2", ... with a warning, so that every body has a name of its own.
void make_names_unique(std::vector<Body>& bodies, std::vector<std::string>& warnings);

}  // namespace amiss::world
