// Numbers in text, whatever the locale.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace amiss::mapping {

/// The whole text as a number, or nothing.
template <class Number>
[[nodiscard]] std::optional<Number> parse_number(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// The next word from `at` on (blanks as in C), which moves behind it; empty at the end.
[[nodiscard]] inline std::string_view next_word(std::string_view text, std::size_t& at) {
  constexpr std::string_view kBlank = " \t\r\n\v\f";
  const std::size_t first = std::min(text.find_first_not_of(kBlank, at), text.size());
  at = std::min(text.find_first_of(kBlank, first), text.size());
  return text.substr(first, at - first);
}

}  // namespace amiss::mapping
