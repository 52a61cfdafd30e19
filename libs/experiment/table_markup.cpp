#include "experiment/table_markup.hpp"

#include <fmt/format.h>

namespace amiss::experiment {

namespace {

constexpr const char* kStyle =
    "body{font:15px/1.5 system-ui,sans-serif;max-width:70em;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse}th,td{padding:.2em .8em;text-align:right}th{border-bottom:2px solid #444}"
    "th:nth-child(-n+2),td:nth-child(-n+2){text-align:left}tr.group td{border-top:1px solid #999}";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

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

std::string html_row(const std::vector<std::string>& fields, const char* cell, const char* attributes) {
  std::string row = fmt::format("<tr{}>", attributes);
  for (const std::string& field : fields) row += fmt::format("<{}>{}</{}>", cell, escaped(field), cell);
  return row + "</tr>\n";
}

}  // namespace

std::string to_markdown(const Table& table) {
  std::string text = markdown_line(table.heading);
  text += markdown_line(std::vector<std::string>(table.heading.size(), "---"));
  for (const auto& row : table.rows) text += markdown_line(row);
  return text;
}

std::string to_page(const std::string& title, const std::vector<std::string>& sentences, const Table& table) {
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title><style>{1}</style></head>\n"
      "<body><h1>{0}</h1>\n",
      escaped(title), kStyle);
  for (const std::string& sentence : sentences) page += fmt::format("<p>{}</p>\n", escaped(sentence));
  page += "<table>\n" + html_row(table.heading, "th", "");
  std::string group;
  for (const auto& row : table.rows) {
    const bool begins = !row.empty() && row.front() != group;
    if (begins) group = row.front();
    page += html_row(row, "td", begins ? " class=\"group\"" : "");
  }
  return page + "</table></body></html>\n";
}

}  // namespace amiss::experiment
