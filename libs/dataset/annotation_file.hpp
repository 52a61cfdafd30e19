// Which points of a cloud belong to which object: ObChange's .anno files.
// One object a line: "name index index ... [true|false]"; indices from 0 into the cloud beside it; the last word, where
// it is there, says whether the object lies on the floor. Names have no spaces; a name may come again: its points are
// then put together. All names of a file with "airplane" in them are one object: ObChange's airplane lies in parts.
// Errors: InputError with file and line: no number, an index that the cloud does not have, no name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace amiss::dataset {

struct AnnotatedObject {
  std::string name;
  std::vector<std::uint32_t> points;
  std::optional<bool> on_floor;  // nothing where the file does not say
};

/// `points`: how many the cloud has.
[[nodiscard]] std::vector<AnnotatedObject> parse_annotations(std::string_view bytes, const std::string& name,
                                                             std::size_t points);
[[nodiscard]] std::string annotation_bytes(const std::vector<AnnotatedObject>& objects);

}  // namespace amiss::dataset
