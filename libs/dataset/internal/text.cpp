#include "dataset/internal/text.hpp"

#include <charconv>
#include <cmath>

#include "core/result.hpp"

namespace amiss::dataset {

void refuse_line(const std::string& name, int line, const std::string& what) {
  throw InputError(name + ":" + std::to_string(line) + ": " + what);
}

std::string shown(std::string_view word) {
  constexpr std::size_t kMost = 24;
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const char c : word) {
    if (text.size() >= kMost) return text + "...";
    const auto byte = static_cast<unsigned char>(c);
    const bool printable = byte >= 0x20 && byte < 0x7f;
    text += printable ? std::string(1, c) : std::string("\\x") + kDigits[byte >> 4U] + kDigits[byte & 15U];
  }
  return text;
}

double finite_number(std::string_view word, const std::string& name, int line) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool read = end == word.data() + word.size() && !word.empty() && error != std::errc::invalid_argument;
  if (error == std::errc::result_out_of_range) value = 0.0;
  if (!read || !std::isfinite(value)) {
    refuse_line(name, line, "'" + shown(word) + "' is no finite number");
  }
  return value;
}

Stamp stamp_of(std::string_view word, const std::string& name, int line) {
  const std::size_t point = std::min(word.find('.'), word.size());
  std::string_view whole = word.substr(0, point);
  std::string digits(point < word.size() ? word.substr(point + 1, 9) : std::string_view());
  digits.resize(9, '0');
  long long seconds_s = 0, nanoseconds = 0;
  const auto a = std::from_chars(whole.data(), whole.data() + whole.size(), seconds_s);
  const auto b = std::from_chars(digits.data(), digits.data() + digits.size(), nanoseconds);
  const bool read = a.ec == std::errc() && a.ptr == whole.data() + whole.size() && b.ec == std::errc() &&
                    b.ptr == digits.data() + digits.size();
  if (!read || seconds_s < 0 || seconds_s > 9'000'000'000 || nanoseconds < 0) {
    refuse_line(name, line, "'" + shown(word) + "' is no time in seconds");
  }
  return Stamp(Duration(seconds_s * 1'000'000'000 + nanoseconds));
}

std::string text_of(Stamp stamp) {
  const long long total = stamp.time_since_epoch().count();
  std::string fraction = std::to_string(total % 1'000'000'000);
  fraction.insert(0, 9 - fraction.size(), '0');
  return std::to_string(total / 1'000'000'000) + "." + fraction;
}

}  // namespace amiss::dataset
