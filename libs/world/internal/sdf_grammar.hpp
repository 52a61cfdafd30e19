// The grammar of SDF, cut down to what this library reads of a prepared file (sdf_text.hpp). libsdformat copies the
// whole grammar below an element for each element of a file, sensors, joints and all: most of the time of reading.
#pragma once

#include <sdf/SDFImpl.hh>

namespace amiss::world {

/// Made once for a thread, used for every file: setting it up takes libsdformat tens of milliseconds.
[[nodiscard]] const sdf::SDFPtr& sdf_grammar();

}  // namespace amiss::world
