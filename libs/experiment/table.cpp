#include "experiment/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace amiss::experiment {

namespace {

std::string line_of(const std::vector<std::string>& fields) {
  std::vector<std::string> plain = fields;
  for (std::string& field : plain) {
    std::replace_if(
        field.begin(), field.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
  }
  return fmt::format("{}\n", fmt::join(plain, "\t"));
}

bool begins_like_a_number(const std::string& text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return !text.empty() && (is_digit(text[0]) || text.starts_with("inf") || text == "-" ||
                           (text[0] == '-' && (is_digit(text[1]) || text.starts_with("-inf"))));
}

}  // namespace

std::string number_text(double value) {
  if (std::isnan(value)) return "-";
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  const double rounded = std::round(value * 1e6) / 1e6;
  return fmt::format("{}", rounded == 0.0 ? 0.0 : rounded);  // no -0
}

std::string to_tsv(const Table& table) {
  std::string text = line_of(table.heading);
  for (const auto& row : table.rows) text += line_of(row);
  return text;
}

std::string to_columns(const Table& table) {
  std::vector<std::size_t> widths;
  for (const std::string& word : table.heading) widths.push_back(word.size());
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::vector<bool> right(widths.size(), !table.rows.empty());
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < widths.size(); ++i) right[i] = right[i] && begins_like_a_number(row[i]);
  }
  const auto line = [&](const std::vector<std::string>& fields) {
    std::string text;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      text += i == 0 ? "" : "  ";
      text += right[i] ? fmt::format("{:>{}}", fields[i], widths[i]) : fmt::format("{:<{}}", fields[i], widths[i]);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
  };
  std::string text = line(table.heading);
  for (const auto& row : table.rows) text += line(row);
  return text;
}

}  // namespace amiss::experiment
