// Rows of texts under a heading: as tab-separated values for programs and in columns for people.
#pragma once

#include <string>
#include <vector>

namespace amiss::experiment {

struct Table {
  std::vector<std::string> heading;
  std::vector<std::vector<std::string>> rows;  // each as long as the heading
};

/// At most six decimals, "inf" for infinity, "-" for NaN.
[[nodiscard]] std::string number_text(double value);
/// Tabs and line ends within a text become spaces.
[[nodiscard]] std::string to_tsv(const Table& table);
/// Numbers to the right, all else to the left.
[[nodiscard]] std::string to_columns(const Table& table);

}  // namespace amiss::experiment
