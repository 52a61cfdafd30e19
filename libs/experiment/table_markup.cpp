#include "experiment/table_markup.hpp"

namespace amiss::experiment {

namespace {

std::string markdown_line(const std::vector<std::string>& fields) {
  std::string line = "|";
  for (const std::string& field : fields) {
    line += ' ';
    for (const char c : field) {
      if (c == '|') line += '\\';
      line += c == '\n' || c == '\r' ? ' ' : c;
    }
    line += " |";
  }
  return line + "\n";
}

}  // namespace

std::string to_markdown(const Table& table) {
  std::string text = markdown_line(table.heading);
  text += markdown_line(std::vector<std::string>(table.heading.size(), "---"));
  for (const auto& row : table.rows) text += markdown_line(row);
  return text;
}

void add_grouped(report::Document& page, const Table& table) {
  page.begin_table(table.heading);
  std::string group;
  for (const auto& row : table.rows) {
    const bool begins = !row.empty() && row.front() != group;
    if (begins) group = row.front();
    page.row(row, begins ? report::RowStyle::kGroup : report::RowStyle::kPlain);
  }
  page.end_table();
}

std::string to_page(const std::string& title, const std::vector<std::string>& sentences, const Table& table) {
  report::Document page(title);
  for (const std::string& sentence : sentences) page.paragraph(sentence);
  add_grouped(page, table);
  return page.to_html();
}

}  // namespace amiss::experiment
