// Semantic classes as rows and columns of tables: their places in kSemanticClasses.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/semantic_class.hpp"

namespace amiss::semantics {

inline constexpr std::size_t kClassCount = kSemanticClasses.size();  // kUnlabelled, which is first, among them

namespace detail {
constexpr std::array<std::uint8_t, 256> class_indices() {
  std::array<std::uint8_t, 256> indices{};
  for (std::size_t i = 0; i < kClassCount; ++i) {
    indices[static_cast<std::size_t>(kSemanticClasses[i].value)] = static_cast<std::uint8_t>(i);
  }
  return indices;
}
inline constexpr std::array<std::uint8_t, 256> kClassIndices = class_indices();
}  // namespace detail

[[nodiscard]] constexpr std::size_t index_of(SemanticClass value) {
  return detail::kClassIndices[static_cast<std::size_t>(value)];
}

}  // namespace amiss::semantics
