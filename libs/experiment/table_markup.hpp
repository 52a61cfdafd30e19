// A table as Markdown and as a page in HTML, for reading and for papers.
#pragma once

#include <string>
#include <vector>

#include "experiment/table.hpp"

namespace amiss::experiment {

/// Vertical lines within a text are escaped.
[[nodiscard]] std::string to_markdown(const Table& table);

/// A page by itself: title, sentences, the table. Rows that begin a new group (another text in the first column) get a
/// line above them. All texts are escaped; nothing is loaded.
[[nodiscard]] std::string to_page(const std::string& title, const std::vector<std::string>& sentences,
                                  const Table& table);

}  // namespace amiss::experiment
