// Which classes carry objects: footnote 1 of Section 5.2.1.
#pragma once

#include "core/semantic_class.hpp"

namespace amiss::segment {

/// Floor, cabinet, bed, chair, sofa, table, bookshelf, counter, desk, shelves, night stand, other structure, other
/// furniture, other props. Shelves, night stand and other structure have numbers of NYU40 beyond the 21 classes.
[[nodiscard]] bool may_support(SemanticClass value);

}  // namespace amiss::segment
