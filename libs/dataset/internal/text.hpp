// Numbers and times in text files, with the line in every error.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/stamp.hpp"

namespace amiss::dataset {

/// InputError "NAME:LINE: what".
[[noreturn]] void refuse_line(const std::string& name, int line, const std::string& what);

/// A word of a file for a sentence: its first characters, what cannot be printed as \x and two digits.
[[nodiscard]] std::string shown(std::string_view word);

/// A finite number; anything else is refused.
[[nodiscard]] double finite_number(std::string_view word, const std::string& name, int line);

/// "1305031102.175304" -> nanoseconds, exactly; 0 .. 9e9 s.
[[nodiscard]] Stamp stamp_of(std::string_view word, const std::string& name, int line);
/// Seconds with nine digits behind the point.
[[nodiscard]] std::string text_of(Stamp stamp);

}  // namespace amiss::dataset
