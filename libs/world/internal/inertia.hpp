// Mass and inertia of an SDF link: what physics cannot use is repaired.
#pragma once

#include <string>
#include <vector>

namespace tinyxml2 {
class XMLElement;
}

namespace amiss::world {

/// Changes the <inertial> element so that the mass is positive and finite and the inertia is either valid (positive,
/// triangle inequality) or absent. One sentence for each repair.
std::vector<std::string> repair_inertial(tinyxml2::XMLElement& inertial);

}  // namespace amiss::world
