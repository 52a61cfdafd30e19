// A table as Markdown and as a page in HTML, for reading and for papers.
#pragma once

#include <string>
#include <vector>

#include "experiment/table.hpp"
#include "report/document.hpp"

namespace amiss::experiment {

/// Vertical lines within a text are escaped.
[[nodiscard]] std::string to_markdown(const Table& table);

/// Rows that begin a new group (another text in the first column) get a line above them.
void add_grouped(report::Document& page, const Table& table);

/// A page by itself: title, sentences, the table grouped.
[[nodiscard]] std::string to_page(const std::string& title, const std::vector<std::string>& sentences,
                                  const Table& table);

}  // namespace amiss::experiment
